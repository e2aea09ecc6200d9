package dev.twister.oracle;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.scene.Camera;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Emission;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The scenes of which {@code src/test/resources/path-references} has what another renderer finds. */
final class PathReferences {
    static final Path FOLDER = Path.of("src/test/resources/path-references");

    private static final Path KNOT = Path.of("knot");
    private static final Skybox BLACK = new Skybox(1, 1, new float[3]);
    private static final Material WHITE =
            Material.DEFAULT.withColor(new Rgb(0.73, 0.73, 0.73)).withReflectivity(0);

    private PathReferences() {}

    static LitScene scene(String name, int width, int height, int samples) {
        LitScene scene = switch (name) {
            case "weekend" -> ShippedScenes.small("weekend");
            case "box" -> box();
            case "knot" -> knot();
            default -> throw new IllegalArgumentException(name);
        };
        Rendering settings = scene.scene()
                .rendering()
                .withSize(width, height)
                .withSamplesPerPixel(samples)
                .withIntegrator(Integrator.PATH)
                .withClamp(0);
        return new LitScene(scene.scene().withRendering(settings), scene.images(), scene.meshes());
    }

    /** A closed room with the camera inside, lit by a rectangle, with a mirror and a glass sphere. */
    private static LitScene box() {
        Scene scene = under(50, Camera.of(new Vector3(0, 1, -3.3), 0, 0, 45))
                .withGround(Ground.of(1, -500, new Rgb(0, 0, 0), new Rgb(0, 0, 0), 0))
                .withSpheres(List.of(
                        Sphere.of(
                                new Vector3(-0.5, 0.45, 0.3),
                                0.45,
                                WHITE.withColor(new Rgb(0.95, 0.95, 0.95))
                                        .withReflectivity(128)
                                        .withMetallic(1)),
                        Sphere.of(
                                new Vector3(0.5, 0.4, -0.4),
                                0.4,
                                WHITE.withColor(new Rgb(1, 1, 1)).withTransmission(1))))
                .withMeshes(List.of(
                        quad(2.6, 4.4, new Vector3(0, 0, -1.2), new Rotation(0, 90, 0), WHITE),
                        quad(2.6, 4.4, new Vector3(0, 2, -1.2), new Rotation(0, -90, 0), WHITE),
                        quad(2.6, 2, new Vector3(0, 1, 1), Rotation.NONE, WHITE),
                        quad(2.6, 2, new Vector3(0, 1, -3.4), Rotation.NONE, WHITE),
                        quad(
                                4.4,
                                2,
                                new Vector3(-1.3, 1, -1.2),
                                new Rotation(90, 0, 0),
                                WHITE.withColor(new Rgb(0.65, 0.05, 0.05))),
                        quad(
                                4.4,
                                2,
                                new Vector3(1.3, 1, -1.2),
                                new Rotation(90, 0, 0),
                                WHITE.withColor(new Rgb(0.12, 0.45, 0.15))),
                        quad(
                                0.8,
                                0.6,
                                new Vector3(0, 1.99, 0),
                                new Rotation(0, -90, 0),
                                WHITE.withColor(new Rgb(0, 0, 0))
                                        .withEmission(new Emission(new Rgb(17, 12, 7), 1, false, LightGroup.NONE)))));
        return new LitScene(scene, SceneImages.of(BLACK), SceneMeshes.read(scene, _ -> {}));
    }

    private static Mesh quad(double width, double height, Vector3 center, Rotation rotation, Material material) {
        return Mesh.of(new Shape(Shape.Kind.QUAD, new Vector3(width, height, 0)))
                .withPosition(center)
                .withRotation(rotation)
                .withMaterial(material);
    }

    /** A rough metal knot of 100,000 triangles on a plane, under a sky with a sun. */
    private static LitScene knot() {
        Material gold = WHITE.withColor(new Rgb(1, 0.78, 0.34))
                .withReflectivity(128)
                .withMetallic(1)
                .withRoughness(Math.sqrt(0.2));
        Rgb floor = new Rgb(0.4, 0.38, 0.35);
        double pitch = Math.toDegrees(Math.atan2(2.3, 8));
        Scene scene = under(16, Camera.of(new Vector3(0.35, 4.2, -9.5), 0, pitch, 46))
                .withGround(Ground.of(60, 0, floor, floor, 0))
                .withMeshes(List.of(Mesh.of(new Geometry.OfFile(KNOT)).withMaterial(gold)));
        MeshFile file = new MeshFile(
                List.of(TorusKnot.mesh(1000, 50)),
                List.of(new MeshPart("", 0, Affine.IDENTITY, Material.DEFAULT)),
                Map.of(),
                0);
        Skybox sky = SkyboxReader.read(FOLDER.resolve("sunny.hdr"), _ -> {});
        return new LitScene(scene, SceneImages.of(sky), SceneMeshes.of(scene, _ -> file));
    }

    /** Without a light of its own: it is black, and far below. */
    private static Scene under(int bounces, Camera camera) {
        return Scene.under(Path.of("none.hdr"))
                .withCamera(camera)
                .withLights(Lights.of(Light.of(new Vector3(0, -600, 0), 1, new Rgb(0, 0, 0))))
                .withRendering(Rendering.DEFAULT.withBounces(bounces));
    }
}
