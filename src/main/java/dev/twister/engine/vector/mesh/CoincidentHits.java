package dev.twister.engine.vector.mesh;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Coincidence;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.world.Bodies;

/** Decides lane by lane between hits that may be in one place: {@link Coincidence}. */
final class CoincidentHits {
    private CoincidentHits() {}

    /**
     * Writes the triangle as the hit of those rays for which it replaces the closest one so far.
     *
     * @param close one bit per ray, with its distance to the triangle in {@link PacketWalk#MET}
     * @param number the triangle's instance
     */
    static void decide(Drawing drawing, Tile tile, MeshMemory bench, int at, long close, int triangle, int number) {
        Bodies bodies = drawing.input.bodies();
        float[] frame = drawing.input.view().frame();
        float[] hierarchy = bodies.floats();
        float[] t = tile.values;
        float[] r = bench.mesh.rays;
        float[] path = bench.path;
        int instance = Instance.at(number, bodies.instances(), hierarchy);
        for (long rest = close; rest != 0L; rest &= rest - 1) {
            int lane = Long.numberOfTrailingZeros(rest);
            int pixel = at + lane;
            float met = r[PacketWalk.MET + lane];
            path[Layout.INSTANCE] = t[pixel + Tile.INSTANCE];
            path[Layout.TRIANGLE] = t[pixel + Tile.TRIANGLE];
            int hit = (int) t[pixel + Tile.HIT];
            float end = r[PacketWalk.END + lane];
            if (Coincidence.replaces(path, hit, end, met, number, triangle, frame, hierarchy, bodies.meshes()) != 0) {
                r[PacketWalk.END + lane] = met;
                t[pixel + Tile.DISTANCE] = met;
                t[pixel + Tile.HIT] = hierarchy[instance + Layout.INSTANCE_BODY];
                t[pixel + Tile.INSTANCE] = number;
                t[pixel + Tile.TRIANGLE] = triangle;
            }
        }
    }
}
