package dev.twister.engine.vector;

import dev.twister.engine.JvmKernel;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.ShadowCandidates;
import dev.twister.kernel.Layout;

/**
 * Passes declined work to the scalar kernel: the rest of a path from a given bounce on, the visible part of a light, or
 * a whole tile.
 */
final class Handover {
    private final JvmKernel kernel = new JvmKernel();

    /** Lets the kernel follow each live ray that hits a declined body, and ends that ray in lanes. */
    void endAtHits(Tile tile, Drawing drawing, int bounce) {
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
                int hit = (int) t[pixel + Tile.HIT];
                if (hit >= Layout.LIGHT && drawing.declined.isBody(hit)) {
                    end(tile, drawing, pixel, bounce);
                }
            }
        }
    }

    /**
     * Lets the kernel compute the visible part of the light at each point that has a declined body or the plane among
     * its possible occluders. The other points stay in {@link Tile#shadows}.
     */
    void findDeclinedShadows(Tile tile, Drawing drawing, int bounce) {
        float[] t = tile.values;
        int kept = 0;
        ShadowCandidates.findDiscs(tile, drawing);
        for (int k = 0; k < tile.shadows.count; k++) {
            int at = tile.shadows.places[k];
            long open = ShadowCandidates.open(tile, at);
            long declined = open & ShadowCandidates.declined(tile, at, drawing);
            for (long rest = declined; rest != 0L; rest &= rest - 1) {
                int pixel = at + Long.numberOfTrailingZeros(rest);
                t[pixel + Tile.VISIBLE] = visible(t, drawing, tile.light, pixel, bounce);
                t[pixel + Tile.SHADOW_OPEN] = 0f;
            }
            if (open != declined) {
                tile.shadows.places[kept] = at;
                kept++;
            }
        }
        tile.shadows.count = kept;
    }

    private void end(Tile tile, Drawing drawing, int pixel, int bounce) {
        float[] t = tile.values;
        float[] path = kernel.path();
        takeRay(t, pixel);
        for (int channel = 0; channel < 3; channel++) {
            float tint = t[pixel + Tile.TINT_RED + channel * Tile.SIZE];
            path[Layout.THROUGHPUT + channel] = t[pixel + Tile.THROUGHPUT] * tint;
            path[Layout.RADIANCE + channel] = t[pixel + Tile.RED + channel * Tile.SIZE] * tint;
        }
        path[Layout.PIXEL_COLUMN] = tile.left + t[pixel + Tile.PLACE_X];
        path[Layout.PIXEL_ROW] = drawing.input.firstRow() + tile.top + t[pixel + Tile.PLACE_Y];
        path[Layout.PIXEL_SAMPLE] = drawing.input.view().samplePlace(tile.sample);
        kernel.follow(drawing.input, bounce);
        for (int channel = 0; channel < 3; channel++) {
            t[pixel + Tile.RED + channel * Tile.SIZE] = path[Layout.RADIANCE + channel];
            t[pixel + Tile.TINT_RED + channel * Tile.SIZE] = 1f;
        }
        t[pixel + Tile.THROUGHPUT] = 0f;
        t[pixel + Tile.WHOLE] = 0f;
        t[pixel + Tile.SHADOW_OPEN] = 0f;
        t[pixel + Tile.HIT] = Tile.ENDED;
    }

    /**
     * Subtracts the light blocked by meshes from the light that passes the spheres. Where both block a part, the kernel
     * computes the visible part.
     */
    void mendShadows(Tile tile, Drawing drawing, int bounce) {
        float[] t = tile.values;
        for (int k = 0; k < tile.meshShadows.count; k++) {
            int at = tile.meshShadows.places[k];
            for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
                float blocked = t[pixel + Tile.MESH_BLOCKED];
                if (blocked != 0f && t[pixel + Tile.VISIBLE] > 0f) {
                    boolean alone = t[pixel + Tile.VISIBLE] >= 1f;
                    t[pixel + Tile.VISIBLE] = alone
                            ? 1f - blocked / drawing.shadowSamples
                            : visible(t, drawing, tile.light, pixel, bounce);
                }
            }
        }
    }

    private float visible(float[] t, Drawing drawing, int light, int pixel, int bounce) {
        float[] path = kernel.path();
        takeRay(t, pixel);
        path[Layout.DISTANCE] = t[pixel + Tile.DISTANCE];
        path[Layout.INSTANCE] = t[pixel + Tile.INSTANCE];
        path[Layout.TRIANGLE] = t[pixel + Tile.TRIANGLE];
        return kernel.visible(drawing.input, (int) t[pixel + Tile.HIT], bounce, drawing.lights[light].body);
    }

    /** Lets the kernel find what rays meet that lanes have stopped at a spot which emits nothing against them. */
    void passSpots(Tile tile, Drawing drawing) {
        float[] t = tile.values;
        float[] path = kernel.path();
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            for (int pixel = at; pixel < at + Lanes.COUNT; pixel++) {
                int hit = (int) t[pixel + Tile.HIT];
                if (hit >= Layout.LIGHT && t[pixel + Tile.THROUGHPUT] > 0f && drawing.input.isSpot(hit)) {
                    takeRay(t, pixel);
                    t[pixel + Tile.HIT] = kernel.hit(drawing.input);
                    t[pixel + Tile.DISTANCE] = path[Layout.DISTANCE];
                    t[pixel + Tile.INSTANCE] = path[Layout.INSTANCE];
                    t[pixel + Tile.TRIANGLE] = path[Layout.TRIANGLE];
                }
            }
        }
    }

    private void takeRay(float[] t, int pixel) {
        float[] path = kernel.path();
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.ORIGIN + axis] = t[pixel + Tile.ORIGIN_X + axis * Tile.SIZE];
            path[Layout.DIRECTION + axis] = t[pixel + Tile.DIRECTION_X + axis * Tile.SIZE];
        }
        path[Layout.LEAVING] = t[pixel + Tile.LEAVING];
        path[Layout.LEAVING_TRIANGLE] = t[pixel + Tile.LEAVING_TRIANGLE];
        path[Layout.INSIDE] = t[pixel + Tile.INSIDE];
    }

    /** Renders the tile's pixels that lie in the frame. */
    void drawTile(Tile tile, Drawing drawing) {
        int right = Math.min(tile.left + Tile.SIDE, drawing.width);
        int bottom = Math.min(tile.top + Tile.SIDE, drawing.rows);
        for (int row = tile.top; row < bottom; row++) {
            kernel.drawRow(drawing.input, drawing.stop, row, tile.left, right);
        }
    }
}
