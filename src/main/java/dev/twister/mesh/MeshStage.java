package dev.twister.mesh;

import dev.twister.mesh.input.QuotedText;
import dev.twister.scene.Camera;
import dev.twister.scene.Geometry;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.SceneLimits;
import dev.twister.scene.select.Title;
import java.nio.file.Path;
import java.util.List;

/** A scene for viewing one mesh: scaled to 2 meters, on the checkered plane, in the center of the picture. */
public final class MeshStage {
    /** Smoothing angle for files without normals. */
    public static final double SMOOTH_DEGREES = 30;

    private static final double LARGEST_SIDE = 2;
    private static final double PLANE_SIZE = 20;

    /** Below the mesh, whose own flat bottom is seen, not the plane; a thousandth of the largest side. */
    private static final double PLANE_HEIGHT = -LARGEST_SIDE / 1000;

    /** Few, because each sample traverses the triangles, and the picture at rest is refined. */
    private static final int SHADOW_SAMPLES = 16;

    private static final double YAW_DEGREES = 20;
    private static final double PITCH_DEGREES = 15;
    private static final double FIELD_OF_VIEW_DEGREES = 40;

    /** Factor for the distance at which the mesh's bounding sphere just fits into the picture. */
    private static final double ROOM = 1.05;

    private static final Rgb BRIGHT = new Rgb(0.8, 0.8, 0.8);
    private static final Rgb DARK = new Rgb(0.35, 0.35, 0.35);
    private static final Light LIGHT = Light.of(new Vector3(-3, 6, -4), 0.5, new Rgb(1, 1, 1));

    private MeshStage() {}

    /** Default file for saving a mesh's scene: beside the mesh. */
    public static Path sceneFile(Path mesh) {
        String name = mesh.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return mesh.toAbsolutePath().resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ".json");
    }

    /**
     * The scene for a mesh. The lights of the file replace the stage's own, its cameras are views.
     *
     * @param source the mesh file
     * @param held its content
     * @param skybox the panorama's file
     * @param pose how the mesh stands
     * @throws MeshException if the mesh cannot be scaled so far
     */
    public static Scene of(Geometry.OfFile source, MeshFile held, Path skybox, MeshPose pose) {
        Path file = source.path();
        Mesh turned = Mesh.of(source).withRotation(pose.rotation(file));
        Box bounds = held.bounds(MeshPlacement.of(turned));
        Vector3 half = bounds.half();
        double largest = 2 * Math.max(half.x(), Math.max(half.y(), half.z()));
        double scale = LARGEST_SIDE / largest;
        if (!(scale >= SceneLimits.FACTOR.min() && scale <= SceneLimits.FACTOR.max())) {
            throw new MeshException(QuotedText.path(file) + ": the mesh is " + (float) largest + " m wide; expected "
                    + LARGEST_SIDE / SceneLimits.FACTOR.max() + " to " + LARGEST_SIDE / SceneLimits.FACTOR.min()
                    + " m; scale it in a scene file or in the program that made it");
        }
        Vector3 center = bounds.center();
        Vector3 place = new Vector3(center.x(), bounds.least().y(), center.z()).times(-scale);
        double radius = scale * half.length();
        double distance = ROOM * radius / Math.sin(Math.toRadians(FIELD_OF_VIEW_DEGREES / 2));
        double yaw = Math.toRadians(YAW_DEGREES);
        double pitch = Math.toRadians(PITCH_DEGREES);
        Vector3 eye = new Vector3(
                -distance * Math.sin(yaw) * Math.cos(pitch),
                scale * half.y() + distance * Math.sin(pitch),
                -distance * Math.cos(yaw) * Math.cos(pitch));
        Mesh mesh = turned.withScale(scale).withPosition(place).withSmoothDegrees(SMOOTH_DEGREES);
        FileSurroundings around = held.surroundings().placed(MeshPlacement.of(mesh));
        StageLights lights = new StageLights(new Vector3(0, scale * half.y(), 0), LARGEST_SIDE / 2);
        return Scene.under(skybox)
                .withTitle(Title.NONE.withName(file.getFileName().toString()))
                .withCamera(Camera.of(eye, YAW_DEGREES, PITCH_DEGREES, FIELD_OF_VIEW_DEGREES))
                .withViews(around.cameras().stream().map(FileCamera::view).toList())
                .withLights(around.lights().isEmpty() ? Lights.of(LIGHT) : lights.of(around.lights(), scale))
                .withRendering(Rendering.DEFAULT.withShadowSamples(SHADOW_SAMPLES))
                .withGround(Ground.of(PLANE_SIZE, PLANE_HEIGHT, BRIGHT, DARK, 0))
                .withMeshes(List.of(mesh));
    }
}
