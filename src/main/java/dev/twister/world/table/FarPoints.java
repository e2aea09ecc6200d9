package dev.twister.world.table;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** The vertices of a mesh file that are farthest out in many directions: few points that describe its outline. */
public final class FarPoints {
    private static final int AXES = 6;
    private static final int DIRECTIONS = AXES + 240;

    /** With more parts, each part contributes only the vertices at the sides of its bounding box. */
    private static final int MOST_PARTS = 1000;

    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    private static final double[][] SPREAD = spread();

    private FarPoints() {}

    /** The points of a file, found when they are first asked for. */
    public static final class Later implements Supplier<List<Vector3>> {
        private final MeshFile file;
        private List<Vector3> found = List.of();

        public Later(MeshFile file) {
            this.file = file;
        }

        @Override
        public synchronized List<Vector3> get() {
            if (found.isEmpty()) {
                found = of(file);
            }
            return found;
        }
    }

    /** The points in the file's coordinates, without duplicates. */
    public static List<Vector3> of(MeshFile file) {
        int directions = file.parts().size() > MOST_PARTS ? AXES : DIRECTIONS;
        List<List<Vector3>> pointsByMesh = file.meshes().stream()
                .map(mesh -> farthest(mesh.positions(), directions))
                .toList();
        if (file.parts().size() == 1 && file.parts().getFirst().placement().equals(Affine.IDENTITY)) {
            return pointsByMesh.get(file.parts().getFirst().mesh());
        }
        List<Vector3> placed = new ArrayList<>();
        for (MeshPart part : file.parts()) {
            pointsByMesh
                    .get(part.mesh())
                    .forEach(point -> placed.add(part.placement().point(point)));
        }
        float[] positions = new float[3 * placed.size()];
        for (int i = 0; i < placed.size(); i++) {
            positions[3 * i] = (float) placed.get(i).x();
            positions[3 * i + 1] = (float) placed.get(i).y();
            positions[3 * i + 2] = (float) placed.get(i).z();
        }
        return farthest(positions, DIRECTIONS);
    }

    /** @param directions number of directions; the axes are the first ones */
    private static List<Vector3> farthest(float[] positions, int directions) {
        List<Vector3> points = new ArrayList<>();
        for (int i = 0; i < directions; i++) {
            double[] direction = SPREAD[i];
            double most = Double.NEGATIVE_INFINITY;
            int farthest = 0;
            for (int at = 0; at < positions.length; at += 3) {
                double along = positions[at] * direction[0]
                        + positions[at + 1] * direction[1]
                        + positions[at + 2] * direction[2];
                if (along > most) {
                    most = along;
                    farthest = at;
                }
            }
            points.add(new Vector3(positions[farthest], positions[farthest + 1], positions[farthest + 2]));
        }
        return points.stream().distinct().toList();
    }

    /** Both directions of each axis, which give the bounding box, then a spiral over the sphere. */
    private static double[][] spread() {
        double[][] directions = new double[DIRECTIONS][3];
        for (int side = 0; side < AXES; side++) {
            directions[side][side / 2] = side % 2 == 0 ? 1 : -1;
        }
        for (int i = 0; i < DIRECTIONS - AXES; i++) {
            double height = 1 - (2 * i + 1.0) / (DIRECTIONS - AXES);
            double across = Math.sqrt(1 - height * height);
            directions[AXES + i] =
                    new double[] {across * Math.cos(i * GOLDEN_ANGLE), height, across * Math.sin(i * GOLDEN_ANGLE)};
        }
        return directions;
    }
}
