package dev.twister.gui.edit;

import dev.twister.scene.Scene;
import dev.twister.scene.TrackTarget;
import java.util.Locale;
import java.util.Optional;

/** The displayed names of what has keyframes. */
public final class TrackTitles {
    private TrackTitles() {}

    /** Such as {@code Sphere 3} or {@code Sky}. */
    public static String of(Scene scene, TrackTarget target) {
        return switch (target.kind()) {
            case CAMERA -> "Camera";
            case LIGHT -> BodyTitles.title(scene, BodyNumber.ofLight(target.index()));
            case PLANE -> "Plane";
            case SPHERE -> BodyTitles.title(scene, BodyNumber.ofSphere(target.index()));
            case MESH -> BodyTitles.title(scene, BodyNumber.ofMesh(target.index()));
            case SKY -> "Sky";
            case SHADING -> "Ambient light";
            case RENDERING -> "Picture";
        };
    }

    /** Such as {@code Emission strength}. */
    public static String property(String name) {
        String words = name.replaceAll("([A-Z])", " $1").toLowerCase(Locale.ROOT);
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    /** What keyframes of a selected body are of; empty for a poured sphere and for nothing. */
    public static Optional<TrackTarget> target(Scene scene, int body) {
        if (BodyEdits.isLight(scene, body)) {
            return Optional.of(TrackTarget.light(BodyNumber.light(body)));
        }
        if (BodyEdits.isMesh(scene, body)) {
            return Optional.of(TrackTarget.mesh(BodyNumber.mesh(body)));
        }
        if (BodyEdits.isSphere(scene, body)) {
            return Optional.of(TrackTarget.sphere(BodyNumber.sphere(body)));
        }
        return Optional.of(TrackTarget.PLANE).filter(_ -> body == BodyNumber.PLANE);
    }
}
