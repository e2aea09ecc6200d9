package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;

/**
 * How a film plays an animation of a mesh's file.
 *
 * @param name the animation's name in the file, or its number from 0; empty for a mesh at rest
 * @param start the animation's time at the beginning of the film, in seconds
 * @param speed seconds of the animation per second of the film; below 0 it plays backwards
 * @param loop whether it begins again where it ends; otherwise it stops there
 */
@Copied
public record MeshAnimation(String name, double start, double speed, boolean loop) implements MeshAnimationCopy.With {
    /** A mesh at rest; has the values of the fields that a scene file leaves out. */
    public static final MeshAnimation NONE = new MeshAnimation("", 0, 1, true);

    public MeshAnimation {
        requireNonNull(name, "name");
    }

    /** An animation, played from its beginning again and again. */
    public static MeshAnimation of(String name) {
        return NONE.withName(name);
    }

    public boolean isNone() {
        return name.isEmpty();
    }

    /** The animation as it goes on from a time of the film. */
    public MeshAnimation at(double seconds) {
        return isNone() ? this : withStart(start + speed * seconds);
    }

    /**
     * The time of the animation at the beginning of the film.
     *
     * @param length of the animation, in seconds
     * @return in [0, length]
     */
    public double time(double length) {
        if (!(length > 0)) {
            return 0;
        }
        return loop ? Math.clamp(start - length * Math.floor(start / length), 0, length) : Math.clamp(start, 0, length);
    }
}
