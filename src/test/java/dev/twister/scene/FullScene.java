package dev.twister.scene;

import dev.twister.mesh.MeshFile;
import dev.twister.oracle.MeshShapes;
import dev.twister.scene.generate.Palette;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Attenuation;
import dev.twister.scene.material.Emission;
import dev.twister.scene.select.SceneBodies;
import dev.twister.scene.select.Tag;
import dev.twister.scene.select.Title;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.Function;

/** A scene in which nothing is left out: every list has an item, every optional value is there. */
public final class FullScene {
    private static final Path TEXTURE = Path.of("texture.png");
    private static final Path MESH = Path.of("mesh.obj");

    public static final Scene SCENE = scene();

    /** Reads the meshes of this scene, or of a changed one. */
    public static final Function<SceneMeshes.Source, MeshFile> MESHES = _ -> MeshShapes.file(MeshShapes.icosphere(1));

    private FullScene() {}

    private static Scene scene() {
        Material glass = material(0.6, 20);
        Camera camera = new Camera(new Vector3(0, 2, -6), 3, 10, Camera.Projection.FISHEYE, 50, 4, 0.1, 7, List.of());
        SequencedMap<String, Material> materials = new LinkedHashMap<>();
        materials.put("glass", glass);
        return new Scene(
                new Title("Full", "Everything."),
                camera.withKeyframes(List.of(CameraKeyframe.of(2, camera))),
                List.of(new CameraView("front", camera)),
                new Lights(List.of(
                        Light.of(new Vector3(1, 1.6, 0), 0.3, new Rgb(0.9, 0.8, 0.7))
                                .withStrength(5.0)
                                .withShare(0.75)
                                .withGroup("lamp"),
                        Light.of(new Vector3(-1, 2.2, 0.5), 0.2, new Rgb(0.2, 0.4, 0.9)),
                        Light.sun(new Vector3(0.3, -1, 0.2), 4),
                        Light.spot(new Vector3(0, 3, 0), 0.1, new Vector3(0.1, -1, 0), 40))),
                materials,
                new Ground(5, 0, new Rgb(0.1, 0.2, 0.3), material(0.3, 10)),
                new SceneBodies(
                        List.of(
                                Sphere.of(new Vector3(1.1, 3, 0.1), 0.4, glass),
                                Sphere.of(new Vector3(-1, 1.5, 0), 0.3, material(0.2, 40))),
                        List.of(new Mesh(
                                new Geometry.OfFile(MESH),
                                new Vector3(-1, 0.2, 0),
                                new Rotation(20, 10, 30),
                                0.6,
                                25,
                                new MeshAnimation("Walk", 0.25, -1.5, false),
                                Optional.of(material(0.7, 0)),
                                Tag.NONE))),
                new Sky(Path.of("sky.hdr"), 30, 1.5),
                new Shading(0.3),
                new Rendering(40, 30, 4, 3, 2, 0.5, ToneMap.ACES, true, Integrator.PATH, 25, 0.5),
                new Physics(new Vector3(0.5, -9, 0.25), 0.5, 0.3, 0.1, true, true),
                Optional.of(
                        new Pour(3, 4, new Vector3(0.5, 2.5, 0.5), 0.5, 2, 0.1, 0.2, Palette.DUSK, material(0, 30), 7)),
                List.of(Track.of(TrackTarget.sphere(0), "position", Keyframe.of(1, new Vector3(1, 2, 3)))));
    }

    private static Material material(double transmission, double reflectivity) {
        return Material.DEFAULT
                .withColor(new Rgb(0.5, 0.6, 0.7))
                .withReflectivity(reflectivity)
                .withRoughness(0.2)
                .withMetallic(0.4)
                .withTransmission(transmission)
                .withIor(1.4)
                .withTexture(TEXTURE)
                .withEmission(new Emission(new Rgb(3, 2, 1), 0.5, false, "lamp"))
                .withAttenuation(new Attenuation(new Rgb(0.9, 0.8, 0.7), Optional.of(2.5)));
    }
}
