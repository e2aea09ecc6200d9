import dev.twister.SceneBuilder;
import dev.twister.Twister;
import dev.twister.scene.Camera;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/** Checks a prism, and shows it: {@code java -cp CLASSPATH CheckShape.java [solution]}. */
final class CheckShape {
    private static final Path PICTURE = Path.of("shape.png");
    private static final int SIDES = 6;
    private static final double HEIGHT = 2;

    private CheckShape() {}

    /** An edge, from one vertex to another. */
    private record Edge(Vector3 from, Vector3 to) {}

    public static void main(String[] arguments) throws IOException {
        System.exit(run(arguments));
    }

    static int run(String... arguments) throws IOException {
        Triangles prism = Checks.isSolution(arguments)
                ? ShapeSolution.prism(SIDES, HEIGHT)
                : ShapeAttempt.prism(SIDES, HEIGHT);
        Checks checks = new Checks();
        checks.that(
                prism.triangleCount() == 4 * SIDES - 4,
                "it has " + prism.triangleCount() + " triangles, but two for each of 6 walls, and 4 at each end, are "
                        + (4 * SIDES - 4));
        Map<Edge, Integer> edges = new HashMap<>();
        double volume = 0;
        for (int triangle = 0; triangle < prism.triangleCount(); triangle++) {
            Vector3 a = corner(prism, triangle, 0);
            Vector3 b = corner(prism, triangle, 1);
            Vector3 c = corner(prism, triangle, 2);
            edges.merge(new Edge(a, b), 1, Integer::sum);
            edges.merge(new Edge(b, c), 1, Integer::sum);
            edges.merge(new Edge(c, a), 1, Integer::sum);
            // In axes that are left-handed, as Twister's, clockwise from outside is positive.
            volume += a.dot(b.cross(c)) / 6;
        }
        long open = edges.keySet().stream()
                .filter(edge -> edges.get(edge) != 1 || edges.getOrDefault(new Edge(edge.to(), edge.from()), 0) != 1)
                .count();
        checks.that(
                open == 0,
                open + " edges are not shared by two triangles that run along them in opposite directions: it is not"
                        + " closed, or some triangles face inward");
        checks.near("the volume", volume, SIDES / 2d * Math.sin(2 * Math.PI / SIDES) * HEIGHT, 1e-5);
        Twister.render(new SceneBuilder()
                        .camera(Camera.of(new Vector3(0, 3, -6), 0, 18, 40))
                        .mesh(Mesh.of(prism)
                                .withPosition(new Vector3(0, 1, 0))
                                .withRotation(new Rotation(15, 0, 0))
                                .withMaterial(Material.DEFAULT.withColor(new Rgb(0.3, 0.6, 0.8)).withReflectivity(20)))
                        .rendering(Rendering.DEFAULT.withSize(320, 180).withShadowSamples(16)))
                .writePng(PICTURE);
        return checks.report(PICTURE + " has the prism on the plane");
    }

    private static Vector3 corner(Triangles mesh, int triangle, int corner) {
        return mesh.vertex(mesh.corner(triangle, corner));
    }
}
