package dev.twister.engine.vector.shortcut;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.vector.crowd.TraversalMemory;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.ShadowMemory;
import dev.twister.engine.vector.shadow.Shadows;
import dev.twister.image.Frame;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class ShadowRangeTest {
    /** Distance from the point to the disc, in meters. */
    private static final float DISTANCE = 10f;

    private static final Scene SCENE = SceneReader.read(Path.of("scenes/teaching.json"));

    private final Tile tile = new Tile();
    private final ShadowMemory bench = new ShadowMemory(new TraversalMemory());
    private final ShadowColumns scratch = bench.columns;
    private final Random random = new Random(20261123);

    /**
     * Near and far spheres whose shadows lie inside the disc, over its rim, beyond it, over all of it and over each
     * other.
     */
    @ParameterizedTest
    @CsvSource({"1,200", "2,200", "3,200", "5,100", "1,48", "2,400"})
    void countsWhatALookAtAllSamplesCounts(int candidates, int samples) {
        Drawing drawing = drawing(samples);
        int looks = 0;
        int left = 0;
        for (int packet = 0; packet < 2000; packet++) {
            place(candidates);
            count(drawing, false);
            float[] all = blocked();
            left += count(drawing, true);
            looks += candidates * samples;
            assertThat(blocked())
                    .as("packet %d: %s", packet, Arrays.toString(all))
                    .isEqualTo(all);
        }
        assertThat(left).as("samples left to test, of %d", looks).isBetween(looks / 100, looks * 3 / 4);
    }

    private static Drawing drawing(int samples) {
        World world = World.of(SCENE, SkyboxReader.read(SCENE.sky().file()));
        world.setSettings(world.settings().withSize(8, 8).withShadowSamples(samples));
        FrameInput input = world.snapshot();
        Drawing drawing = new Drawing();
        drawing.take(input, Frame.ofPixels(input.width(), input.rows()), false);
        return drawing;
    }

    /** Places candidates as seen from a packet's neighboring points, wholly between the points and the disc. */
    private void place(int candidates) {
        scratch.startPacket();
        scratch.reserveBodies(candidates);
        scratch.reserveFacts(candidates);
        float scale = (float) Math.pow(2, -6 + 6 * random.nextDouble());
        Arrays.fill(scratch.frame, ShadowColumns.SCALE, ShadowColumns.SCALE + Lanes.COUNT, scale);
        float apart = (float) Math.pow(10, -4 + 4 * random.nextDouble());
        for (int c = 0; c < candidates; c++) {
            float along = DISTANCE * (0.02f + 0.9f * random.nextFloat());
            // Offset and radius are in radii of the light's cone at the sphere; the sphere's radius is at least 1/16 of
            // that.
            float cone = along * scale;
            float across = 3f * random.nextFloat();
            double angle = 2 * Math.PI * random.nextDouble();
            float radius = cone * (float) Math.pow(2, -3.9 + 7 * random.nextDouble());
            for (int lane = 0; lane < Lanes.COUNT; lane++) {
                fill(c, lane, along, cone, across, angle, radius, apart);
            }
            scratch.candidates.add(c + 2);
        }
        for (int lane = 0; lane < Lanes.COUNT; lane++) {
            boolean open = lane == 0 || random.nextInt(8) > 0;
            tile.values[Tile.SHADOW_OPEN + lane] = open ? 1f : 0f;
            scratch.touched |= open ? 1L << lane : 0L;
        }
        scratch.conical = true;
        ShadowConics.prepare(scratch);
    }

    private void fill(
            int candidate, int lane, float along, float cone, float across, double angle, float radius, float apart) {
        int at = candidate * ShadowColumns.STRIDE + lane;
        float a = along * (1f + 0.01f * apart * random.nextFloat());
        float u = cone * (across * (float) Math.cos(angle) + apart * random.nextFloat());
        float w = cone * (across * (float) Math.sin(angle) + apart * random.nextFloat());
        boolean between = a * a + u * u + w * w > radius * radius && a + radius < DISTANCE && random.nextInt(16) > 0;
        scratch.facts[at + ShadowColumns.ALONG] = a;
        scratch.facts[at + ShadowColumns.ACROSS_U] = u;
        scratch.facts[at + ShadowColumns.ACROSS_W] = w;
        scratch.facts[at + ShadowColumns.RADIUS_SQUARED] = between ? radius * radius : -1f;
    }

    /** Counts blocked samples; returns the number of samples of all candidates that are left to test. */
    private int count(Drawing drawing, boolean sorted) {
        ShadowRange.choose(scratch, drawing);
        scratch.sorted &= sorted;
        ShadowRange.findPlaces(tile, 0, scratch);
        ShadowRange.find(scratch, drawing);
        Shadows.count(tile, drawing, bench, 0);
        int left = 0;
        for (int c = 0; c < scratch.candidates.count; c++) {
            left += scratch.tos[c] - scratch.froms[c];
        }
        return left;
    }

    /** Returns the counts of the active lanes. */
    private float[] blocked() {
        float[] blocked = new float[Lanes.COUNT];
        for (int lane = 0; lane < Lanes.COUNT; lane++) {
            boolean open = tile.values[Tile.SHADOW_OPEN + lane] > 0f;
            blocked[lane] = open ? scratch.frame[ShadowColumns.BLOCKED + lane] : -1f;
        }
        return blocked;
    }
}
