package dev.twister.cli.file;

import dev.twister.files.PrintableText;
import dev.twister.gui.Gui.FirstScene;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPose;
import dev.twister.mesh.MeshReader;
import dev.twister.mesh.MeshStage;
import dev.twister.scene.CameraKeyframe;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sky;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * A mesh file that a command is given, and the scene to look at it in.
 *
 * @param scene the mesh on the checkered plane, under the day sky
 * @param content what was read from the file
 */
public record ModelFile(Scene scene, MeshFile content) {
    private static final int SAMPLES = 4;
    private static final int SHADOW_SAMPLES = 8;

    private static final Ground OUT_OF_SIGHT = Ground.of(1, -1000, new Rgb(0, 0, 0), new Rgb(0, 0, 0), 0);

    /** Whether a file is a mesh by its name. */
    public static boolean isNamed(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return MeshReader.ENDINGS.stream().anyMatch(name::endsWith);
    }

    /**
     * Reads the mesh.
     *
     * @param scene of a glTF file, as in {@link Geometry.OfFile}
     * @param warnings told of what the file says and is not used
     * @throws dev.twister.mesh.MeshException if the file cannot be read
     */
    public static ModelFile read(Path file, String scene, MeshPose pose, Consumer<String> warnings) {
        Geometry.OfFile mesh = new Geometry.OfFile(file.toAbsolutePath().normalize(), scene);
        MeshFile content = MeshReader.read(mesh, MeshStage.SMOOTH_DEGREES, warnings);
        if (pose.animation().isEmpty() && content.rig().clips().size() > 1) {
            warnings.accept(PrintableText.line(file.toString()) + ": there are several animations: "
                    + content.clipNames() + "; the first is played");
        }
        Path sky = Home.skyboxes().resolve(ShippedSky.DAY.fileName());
        return new ModelFile(MeshStage.of(mesh, content, sky.toAbsolutePath().normalize(), pose), content);
    }

    /** What a window opens with. */
    public FirstScene firstScene(Path file) {
        return FirstScene.of(new OpenedScene(MeshStage.sceneFile(file), scene));
    }

    /** The same with smooth edges. */
    public ModelFile forPictures() {
        Rendering settings = scene.rendering().withSamplesPerPixel(SAMPLES).withShadowSamples(SHADOW_SAMPLES);
        return new ModelFile(scene.withRendering(settings), content);
    }

    /** This scene under another sky, which its lamp then fits. */
    public Scene under(Sky sky) {
        Scene under = scene.withSky(sky);
        if (sky.equals(scene.sky())) {
            return under;
        }
        Skybox panorama = SceneImages.read(under.withMeshes(List.of()), _ -> {}).sky();
        return MeshStage.under(sky.strength() * panorama.lightFromAbove(), under);
    }

    /** How a camera of the file moves in the animation, for a view of that name; empty if it rests. */
    public List<CameraKeyframe> path(String view) {
        return MeshStage.path(scene, content, view);
    }

    /** The same without the plane. */
    public ModelFile withoutPlane() {
        return new ModelFile(scene.withGround(OUT_OF_SIGHT), content);
    }

    /** The mesh. */
    public SceneMeshes meshes() {
        return SceneMeshes.of(scene, _ -> content);
    }

    /**
     * The world of this scene, whose pictures are read as {@link SceneImages#read} does.
     *
     * @param shown the scene with other settings, camera or sky
     */
    public World world(Scene shown, Consumer<String> warnings) {
        SceneMeshes meshes = meshes();
        return World.of(shown, SceneImages.read(shown, meshes, warnings), meshes);
    }
}
