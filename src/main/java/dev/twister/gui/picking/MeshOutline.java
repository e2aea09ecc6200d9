package dev.twister.gui.picking;

import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** The outline of a mesh in the picture: the convex hull of its projected points. */
public final class MeshOutline {
    private MeshOutline() {}

    /**
     * Corners of a polygon around a mesh: x and y of each in turn, in pixels of the picture. Empty if a point lies
     * behind the camera.
     *
     * @param farPoints of the mesh, as {@link dev.twister.world.SceneMeshes#farPoints} has them
     */
    public static double[] corners(FrameInput input, List<Vector3> farPoints) {
        Projection projection = Projection.of(input);
        List<double[]> seen = new ArrayList<>();
        for (Vector3 point : farPoints) {
            double[] pixel = projection.point(point);
            if (pixel.length == 0) {
                return new double[0];
            }
            seen.add(pixel);
        }
        seen.sort(Comparator.<double[]>comparingDouble(pixel -> pixel[0]).thenComparingDouble(pixel -> pixel[1]));
        List<double[]> hull = new ArrayList<>(chain(seen));
        hull.addAll(chain(seen.reversed()));
        return hull.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    /** One side of the hull, by Andrew's monotone chain, without its last point, which begins the other side. */
    private static List<double[]> chain(List<double[]> sorted) {
        List<double[]> side = new ArrayList<>();
        for (double[] pixel : sorted) {
            while (side.size() > 1 && !turnsLeft(side.get(side.size() - 2), side.getLast(), pixel)) {
                side.removeLast();
            }
            side.add(pixel);
        }
        if (side.size() > 1) {
            side.removeLast();
        }
        return side;
    }

    private static boolean turnsLeft(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    }
}
