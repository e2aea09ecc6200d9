package dev.twister.gui.edit;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Scene;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Edits of the views that a scene keeps. */
public final class ViewEdits {
    /** The views that number keys lead to. */
    private static final int KEYS = 10;

    private ViewEdits() {}

    /** The place in the list of the view that a number key leads to: 1 to the first one, 0 to the tenth. */
    public static int ofKey(int digit) {
        return (digit + KEYS - 1) % KEYS;
    }

    /** The number key for the view at that place, if there is one. */
    public static Optional<Integer> key(int index) {
        return index < KEYS ? Optional.of((index + 1) % KEYS) : Optional.empty();
    }

    public static boolean isFull(Scene scene) {
        return scene.views().size() >= SceneLimits.MAX_VIEWS;
    }

    /** With another view at the end, under a name that no other one has. */
    public static Scene added(Scene scene, Camera camera) {
        List<CameraView> views = new ArrayList<>(scene.views());
        views.add(new CameraView(freeName(scene), camera));
        return scene.withViews(views);
    }

    private static String freeName(Scene scene) {
        return IntStream.iterate(scene.views().size() + 1, number -> number + 1)
                .mapToObj(number -> "View " + number)
                .filter(name ->
                        scene.views().stream().noneMatch(view -> view.name().equals(name)))
                .findFirst()
                .orElseThrow();
    }

    public static Scene updated(Scene scene, int index, Camera camera) {
        return replaced(scene, index, scene.views().get(index).withCamera(camera));
    }

    public static Scene deleted(Scene scene, int index) {
        List<CameraView> views = new ArrayList<>(scene.views());
        views.remove(index);
        return scene.withViews(views);
    }

    /** With a name that {@link #complaint} has nothing against. */
    public static Scene renamed(Scene scene, int index, String name) {
        return replaced(scene, index, scene.views().get(index).withName(name));
    }

    /** Why a view cannot have that name; empty if it can. */
    public static Optional<String> complaint(Scene scene, int index, String name) {
        int length = name.codePointCount(0, name.length());
        if (length < 1 || length > SceneLimits.MAX_NAME_LENGTH || name.chars().anyMatch(Character::isISOControl)) {
            return Optional.of("A view's name has 1 to " + SceneLimits.MAX_NAME_LENGTH + " characters");
        }
        boolean taken = IntStream.range(0, scene.views().size())
                .anyMatch(other ->
                        other != index && scene.views().get(other).name().equals(name));
        return taken ? Optional.of("Another view is called '" + name + "'") : Optional.empty();
    }

    private static Scene replaced(Scene scene, int index, CameraView view) {
        List<CameraView> views = new ArrayList<>(scene.views());
        views.set(index, view);
        return scene.withViews(views);
    }
}
