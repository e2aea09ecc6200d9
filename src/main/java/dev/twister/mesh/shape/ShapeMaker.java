package dev.twister.mesh.shape;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.assembly.MeshAssembly.Assembled;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.shape.TurnedTriangles.Ring;
import dev.twister.scene.Material;
import dev.twister.scene.Shape;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;
import java.util.List;
import java.util.Map;

/** Makes the triangles of shapes, whose bases are one meter wide. Closed ones are watertight and face outward. */
public final class ShapeMaker {
    private static final double HALF = 0.5;

    private static final int TUBE_STEPS = 64;

    private final ShapeTriangles triangles = new ShapeTriangles();
    private final TurnedTriangles turned = new TurnedTriangles(triangles);

    private ShapeMaker() {}

    /**
     * The mesh of a shape.
     *
     * @param basis see {@link Shape#basis}
     */
    public static MeshFile file(Shape basis) {
        ShapeMaker maker = new ShapeMaker();
        switch (basis.kind()) {
            case BOX -> maker.box();
            case QUAD -> maker.triangles.rectangle(Vector3.ZERO, new Vector3(HALF, 0, 0), new Vector3(0, HALF, 0));
            case CYLINDER -> maker.cylinder();
            case CONE -> maker.cone();
            case TORUS -> maker.torus(basis.size().y() / 2);
            case ICOSPHERE -> new IcosphereTriangles(maker.triangles).add();
        }
        return new MeshFile(
                List.of(maker.triangles.mesh()),
                List.of(new MeshPart(basis.name(), 0, Affine.IDENTITY, Material.DEFAULT)),
                Map.of(),
                0);
    }

    private void box() {
        Vector3 x = new Vector3(HALF, 0, 0);
        Vector3 y = new Vector3(0, HALF, 0);
        Vector3 z = new Vector3(0, 0, HALF);
        triangles.rectangle(z.times(-1), x, y);
        triangles.rectangle(x, z, y);
        triangles.rectangle(z, x.times(-1), y);
        triangles.rectangle(x.times(-1), z.times(-1), y);
        triangles.rectangle(y, x, z);
        triangles.rectangle(y.times(-1), x, z.times(-1));
    }

    private void cylinder() {
        turned.disc(HALF, HALF, 1);
        turned.band(new Ring(HALF, HALF, 1, 0, 0), new Ring(HALF, -HALF, 1, 0, 1));
        turned.disc(HALF, -HALF, -1);
    }

    private void cone() {
        double outward = 2 / Math.sqrt(5);
        double upward = 1 / Math.sqrt(5);
        turned.tip(new Ring(0, HALF, outward, upward, 0), new Ring(HALF, -HALF, outward, upward, 1));
        turned.disc(HALF, -HALF, -1);
    }

    /** The texture's upper and lower edge meet at the inner side. */
    private void torus(double tube) {
        for (int step = 0; step < TUBE_STEPS; step++) {
            turned.band(tubeRing(tube, step), tubeRing(tube, step + 1));
        }
    }

    private static Ring tubeRing(double tube, int step) {
        // The last ring is exactly the first one.
        double turn = Math.PI - 2 * Math.PI * (step % TUBE_STEPS) / TUBE_STEPS;
        double outward = Math.cos(turn);
        double upward = Math.sin(turn);
        return new Ring(HALF - tube + tube * outward, tube * upward, outward, upward, (double) step / TUBE_STEPS);
    }

    /** Makes a mesh of triangles that come from code. */
    public static final class TrianglesOfCode {
        private TrianglesOfCode() {}

        /**
         * The mesh of these triangles.
         *
         * @throws MeshException if no triangle has an area, or there are too many
         */
        public static MeshFile file(Triangles triangles, double smoothDegrees) {
            if (triangles.triangleCount() > MeshLimits.TRIANGLES) {
                throw new MeshException(
                        triangles.name() + ": " + MeshLimits.tooManyTriangles(triangles.triangleCount()));
            }
            Assembled assembled = MeshAssembly.assemble(soup(triangles), Axes.Y_UP, smoothDegrees);
            if (assembled.meshByMaterial().isEmpty()) {
                throw new MeshException(triangles.name() + ": holds no triangle with an area");
            }
            return assembled.file(triangles.name(), Material.DEFAULT);
        }

        /** As a file has them, with z toward the viewer: the mirrored winding is a file's. */
        private static TriangleSoup soup(Triangles triangles) {
            TriangleSoup soup = new TriangleSoup(triangles.vertexCount(), triangles.triangleCount());
            for (int vertex = 0; vertex < triangles.vertexCount(); vertex++) {
                Vector3 position = triangles.vertex(vertex);
                soup.position(position.x(), position.y(), -position.z());
            }
            for (int triangle = 0; triangle < triangles.triangleCount(); triangle++) {
                soup.triangle(
                        triangles.corner(triangle, 0), triangles.corner(triangle, 1), triangles.corner(triangle, 2));
            }
            return soup;
        }
    }
}
