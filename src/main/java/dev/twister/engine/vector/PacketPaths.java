package dev.twister.engine.vector;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.image.Frame;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import dev.twister.kernel.PathTracer;
import dev.twister.kernel.PixelKernel;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/**
 * The traced paths of a tile before {@link PathRehearsal} is over, ray by ray. Packets find the closest hits of all
 * current rays while these fill one; the scalar kernel does everything else.
 */
final class PacketPaths {
    private final TileMemory bench;
    private final BounceRenderer bounces;

    /** One per pixel of the tile; none before the first frame that traces paths. */
    private PixelPath[] paths = {};

    /** The pixels whose paths go on, in the order of the tile. */
    private final int[] alive = new int[Tile.SIZE];

    private int count;

    /** Shares the tile and the hits of the same thread. */
    PacketPaths(TileMemory bench, BounceRenderer bounces) {
        this.bench = bench;
        this.bounces = bounces;
    }

    /** Renders the tile's pixels that lie in the frame, or none of them if the frame is stopped. */
    void draw(Drawing drawing) {
        Tile tile = bench.tile;
        int variant = drawing.input.variant(drawing.frame.isLinear());
        allocate();
        for (PixelPath path : paths) {
            path.blacken();
        }
        for (int sample = 0; sample < drawing.pixelSamples && !drawing.stop.isAsked(); sample++) {
            start(drawing, tile, sample);
            for (int ray = 0; count >= Lanes.COUNT; ray++) {
                findHits(drawing, tile, ray);
                endRays(drawing, tile, variant);
            }
            for (int k = 0; k < count; k++) {
                paths[alive[k]].finish(drawing.input, variant);
            }
        }
        if (!drawing.stop.isAsked()) {
            store(drawing, tile, variant);
        }
    }

    private void allocate() {
        if (paths.length == 0) {
            float[] scratch = new float[Layout.LAYERED_SCRATCH_LENGTH];
            paths = new PixelPath[Tile.SIZE];
            Arrays.setAll(paths, pixel -> new PixelPath(scratch));
        }
    }

    private void store(Drawing drawing, Tile tile, int variant) {
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            if (isInside(drawing, tile, pixel)) {
                paths[pixel].store(
                        drawing.input,
                        drawing.frame,
                        tile.left + Tile.column(pixel),
                        tile.top + Tile.row(pixel),
                        variant);
            }
        }
    }

    private static boolean isInside(Drawing drawing, Tile tile, int pixel) {
        return tile.left + Tile.column(pixel) < drawing.width && tile.top + Tile.row(pixel) < drawing.rows;
    }

    private void start(Drawing drawing, Tile tile, int sample) {
        count = 0;
        for (int pixel = 0; pixel < Tile.SIZE; pixel++) {
            if (isInside(drawing, tile, pixel)) {
                paths[pixel].start(drawing.input, tile.left + Tile.column(pixel), tile.top + Tile.row(pixel), sample);
                alive[count] = pixel;
                count++;
            }
        }
    }

    private void findHits(Drawing drawing, Tile tile, int ray) {
        float[] t = tile.values;
        int packets = (count + Lanes.COUNT - 1) / Lanes.COUNT;
        tile.live.clear();
        for (int packet = 0; packet < packets; packet++) {
            tile.live.add(packet * Lanes.COUNT);
        }
        for (int place = 0; place < packets * Lanes.COUNT; place++) {
            t[place + Tile.THROUGHPUT] = place < count ? 1f : 0f;
        }
        for (int place = 0; place < count; place++) {
            float[] path = paths[alive[place]].floats();
            for (int axis = 0; axis < 3; axis++) {
                t[place + Tile.ORIGIN_X + axis * Tile.SIZE] = path[Layout.ORIGIN + axis];
                t[place + Tile.DIRECTION_X + axis * Tile.SIZE] = path[Layout.DIRECTION + axis];
            }
            t[place + Tile.LEAVING] = path[Layout.LEAVING];
            t[place + Tile.LEAVING_TRIANGLE] = path[Layout.LEAVING_TRIANGLE];
            t[place + Tile.INSIDE] = path[Layout.INSIDE];
        }
        if (ray == 0 && !drawing.crowded && !drawing.lens) {
            bench.choices.cullViewRays(drawing, tile);
        }
        bounces.findHits(drawing, tile, ray, false);
    }

    private void endRays(Drawing drawing, Tile tile, int variant) {
        float[] t = tile.values;
        int kept = 0;
        for (int place = 0; place < count; place++) {
            int pixel = alive[place];
            float[] path = paths[pixel].floats();
            int hit = (int) t[place + Tile.HIT];
            path[Layout.DISTANCE] = hit == Layout.NOTHING ? Intersection.MISS : t[place + Tile.DISTANCE];
            path[Layout.INSTANCE] = t[place + Tile.INSTANCE];
            path[Layout.TRIANGLE] = t[place + Tile.TRIANGLE];
            paths[pixel].end(drawing.input, hit, variant);
            if (isInGlass(drawing, hit)) {
                paths[pixel].finish(drawing.input, variant);
            }
            if (paths[pixel].goesOn()) {
                alive[kept] = pixel;
                kept++;
            }
        }
        count = kept;
    }

    /** Whether the path may be inside a body whose far side lanes do not see: one that transmits, in a crowd. */
    private static boolean isInGlass(Drawing drawing, int hit) {
        return drawing.crowded && hit > Layout.NOTHING && drawing.looks.transmits(hit);
    }

    /** One pixel's traced path on the JVM, which the kernel follows ray by ray. Its hits may be found elsewhere. */
    private static final class PixelPath {
        private final float[] path = new float[Layout.FINISHED_PATH_LENGTH];
        private final float[] scratch;
        private int ray = PathTracer.NO_RAY;
        private int bounce;

        /**
         * Creates a path without rays.
         *
         * @param scratch {@link Layout#LAYERED_SCRATCH_LENGTH} floats, which the paths of one thread may share
         */
        PixelPath(float[] scratch) {
            this.scratch = scratch;
        }

        /** The path's floats: {@link Layout#PATH_LENGTH} and those of {@link PathTracer}. */
        float[] floats() {
            return path;
        }

        /** Sets the sum of the samples to black. */
        void blacken() {
            path[Layout.RADIANCE] = 0f;
            path[Layout.RADIANCE + 1] = 0f;
            path[Layout.RADIANCE + 2] = 0f;
        }

        /** Starts a sample's view ray; the row is that of the band. */
        void start(FrameInput input, int column, int row, int sample) {
            PixelKernel.start(path, column, row, sample, input.view().frame());
            PathTracer.begin(path, input.view().frame(), input.variant(false));
            ray = PathTracer.TO_SURFACE;
            bounce = 0;
        }

        /** Whether there is another ray to follow. */
        boolean goesOn() {
            return ray != PathTracer.NO_RAY;
        }

        /**
         * Ends the current ray, and replaces it by the next one. {@link Layout#DISTANCE}, {@link Layout#INSTANCE} and
         * {@link Layout#TRIANGLE} describe the hit.
         *
         * @param hit the closest body
         */
        void end(FrameInput input, int hit, int variant) {
            float[] frame = input.view().frame();
            Bodies bodies = input.bodies();
            if (ray == PathTracer.TO_EMITTER) {
                boolean blocked = path[Layout.DISTANCE] < path[Layout.LIGHT_DISTANCE];
                ray = PathTracer.light(path, blocked ? hit : Layout.NOTHING, scratch, variant);
            } else {
                ray = PathTracer.arrive(
                        path,
                        hit,
                        bounce,
                        scratch,
                        frame,
                        bodies.floats(),
                        bodies.looks(),
                        bodies.meshes(),
                        input.images(),
                        variant);
                bounce++;
            }
        }

        /** Follows the remaining rays. */
        void finish(FrameInput input, int variant) {
            float[] frame = input.view().frame();
            Bodies bodies = input.bodies();
            while (ray != PathTracer.NO_RAY) {
                int meets = ray == PathTracer.TO_SURFACE ? 1 : 0;
                ray = PathTracer.step(
                        path,
                        bounce,
                        ray,
                        scratch,
                        frame,
                        bodies.floats(),
                        bodies.looks(),
                        bodies.meshes(),
                        input.images(),
                        variant);
                bounce += meets;
            }
        }

        /** Stores the mean of the pixel's samples. */
        void store(FrameInput input, Frame frame, int column, int row, int variant) {
            PixelKernel.store(
                    column,
                    row,
                    frame.argb(),
                    frame.radiance(),
                    frame.layers(),
                    path,
                    scratch,
                    input.view().frame(),
                    variant);
        }
    }
}
