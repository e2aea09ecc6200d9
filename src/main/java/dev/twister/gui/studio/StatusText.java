package dev.twister.gui.studio;

import dev.twister.gui.drawing.DrawingLoop;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.scene.Camera;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.StageOrView;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Texts of the status line. */
public final class StatusText {
    private static final double PERCENT = 100;
    private static final String BETWEEN = " · ";

    private StatusText() {}

    /** Scene, engine, size, number of bodies, and focus of the lens. */
    public static String facts(DrawnPicture picture) {
        String chosen = picture.request().engine().offer().id();
        String name = picture.request().scene().title().name();
        Camera camera = picture.request().scene().camera();
        return Stream.of(
                        name.isEmpty() ? "untitled" : name,
                        picture.request().shown() == StageOrView.BEAUTY
                                ? ""
                                : StagesAndViews.label(picture.request().shown()),
                        (chosen.equals(picture.engine()) ? "" : chosen + ": ") + picture.engine() + " ("
                                + picture.device() + ")",
                        picture.frame().width() + " × " + picture.frame().height(),
                        picture.samples() + (picture.samples() == 1 ? " sample per pixel" : " samples per pixel"),
                        noise(picture),
                        picture.gathered().denoised() ? "denoised" : "",
                        picture.input().bodyCount() + " bodies",
                        meshes(picture.request().scene().meshes().size()),
                        camera.aperture() > 0 ? "focus at " + meters(camera) : "")
                .filter(part -> !part.isEmpty())
                .collect(Collectors.joining(BETWEEN));
    }

    private static String noise(DrawnPicture picture) {
        return picture.noise().isEmpty()
                ? ""
                : String.format(
                        Locale.ROOT, "noise %.2g %%", PERCENT * picture.noise().getAsDouble());
    }

    private static String meshes(int count) {
        return count == 0 ? "" : count + (count == 1 ? " mesh" : " meshes");
    }

    /** The distance that the camera is focused at. */
    public static String focused(Camera camera) {
        return "Focus distance: " + meters(camera)
                + (camera.aperture() > 0 ? "" : ". The aperture is 0: everything is in focus");
    }

    private static String meters(Camera camera) {
        return PropertyNumbers.FOCUS_DISTANCE.scale().text(camera.focusDistance()) + " m";
    }

    /** Whether {@link #facts} are the same for both, without formatting them. */
    public static boolean isSame(DrawnPicture one, DrawnPicture other) {
        return one.request().number() == other.request().number()
                && one.gathered().equals(other.gathered())
                && one.input().bodyCount() == other.input().bodyCount()
                && one.engine().equals(other.engine())
                && one.isWhole()
                && other.isWhole();
    }

    /** What physics will move in a scene. */
    static String whatFalls(Scene scene) {
        int spheres = scene.spheres().size();
        boolean pours = scene.pour().isPresent();
        if (spheres == 0 && !pours) {
            return "Physics on, but the scene has no spheres";
        }
        if (scene.physics().gravity().equals(Vector3.ZERO)) {
            return "Physics on, but gravity is 0: nothing falls";
        }
        return "Physics on: " + spheres + (spheres == 1 ? " sphere" : " spheres")
                + (pours ? ", and more are poured" : "");
    }

    /** The rendering thread's activity or failure; may be empty. */
    public static String message(DrawingLoop.Status status) {
        return Stream.of(
                        status.opening().map(id -> "making engine " + id + " ready…"),
                        status.engineFailure(),
                        status.sceneFailure())
                .flatMap(Optional::stream)
                .collect(Collectors.joining(BETWEEN));
    }
}
