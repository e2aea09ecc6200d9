package dev.twister.engine.vector.shortcut;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.image.Frame;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.World;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

final class GroundAloneTest {
    private static final Rgb GRAY = new Rgb(0.5, 0.5, 0.5);
    private static final int SIDE = 4 * Tile.SIDE;

    private final Drawing drawing = new Drawing();
    private final Tile tile = new Tile();
    private final BoundingCone ground = new BoundingCone();

    @Test
    void theGroundFillsTilesWithinItsEdges() {
        // At a height of 10 m, the picture is 20 m wide and a tile 5 m.
        look(0, 90, 20.1, 10);
        assertThat(fills(0, 0)).isTrue();
        assertThat(ground.baseX).isBetween(-7.6f, -7.4f);
        assertThat(ground.baseY).isZero();
        assertThat(ground.radius).isBetween(3.5f, 3.6f);
        look(0, 90, 19.9, 10);
        assertThat(fills(0, 0)).isFalse();
        assertThat(fills(1, 0)).isFalse();
        assertThat(fills(1, 1)).isTrue();
    }

    @Test
    void theHorizonIsNoneOfIt() {
        look(0, 0, 1e6, 10);
        assertThat(fills(0, 1)).as("above the horizon").isFalse();
        assertThat(fills(0, 2)).as("below the horizon, up to infinity").isFalse();
        assertThat(fills(0, 3)).isTrue();
        look(0, 3, 1e6, 10);
        assertThat(fills(0, 1)).as("on both sides of the horizon").isFalse();
    }

    @Test
    void tilesPastItsEdgesSeeNothing() {
        // At a height of 10 m, a tile is 5 m wide.
        look(0, 90, 9.99, 10);
        assertThat(view(0, 0)).isEqualTo(GroundAlone.View.NOTHING);
        assertThat(view(0, 1)).isEqualTo(GroundAlone.View.NOTHING);
        assertThat(view(1, 1)).isEqualTo(GroundAlone.View.PART);
        look(0, 90, 10.01, 10);
        assertThat(view(0, 0)).isEqualTo(GroundAlone.View.PART);
        // The second-to-last row below the horizon begins 10 m away; the one at the horizon is infinite.
        look(0, 0, 19, 10);
        assertThat(view(1, 3)).isEqualTo(GroundAlone.View.NOTHING);
        assertThat(view(1, 2)).isEqualTo(GroundAlone.View.PART);
        assertThat(view(1, 1)).as("above the horizon").isEqualTo(GroundAlone.View.PART);
    }

    @Test
    void isSeenFromBelowToo() {
        look(0, -90, 30, -10);
        assertThat(fills(0, 0)).isTrue();
        look(0, 90, 30, -10);
        assertThat(fills(0, 0)).isFalse();
    }

    @Test
    void highlightsOfFractionsOfPowersAreOthersTask() {
        look(20.5, 90, 30, 10);
        assertThat(fills(0, 0)).isFalse();
    }

    private void look(double reflectivity, double pitch, double size, double height) {
        World world = World.of(
                Scene.under(Path.of("none.hdr"))
                        .withCamera(Camera.of(new Vector3(0, height, 0), 0, pitch, 90))
                        .withLights(Lights.of(Light.of(new Vector3(0, 30, 0), 1, GRAY)))
                        .withGround(Ground.of(size, 0, GRAY, GRAY, reflectivity))
                        .withShading(new Shading(0.05))
                        .withRendering(Rendering.DEFAULT
                                .withSize(SIDE, SIDE)
                                .withShadowSamples(4)
                                .withBounces(0)),
                new Skybox(1, 1, new float[] {0.5f, 0.5f, 0.5f}));
        drawing.take(world.snapshot(), Frame.ofPixels(SIDE, SIDE), false);
    }

    private boolean fills(int column, int row) {
        return view(column, row) == GroundAlone.View.GROUND;
    }

    private GroundAlone.View view(int column, int row) {
        tile.left = column * Tile.SIDE;
        tile.top = row * Tile.SIDE;
        return GroundAlone.view(tile, drawing, ground);
    }
}
