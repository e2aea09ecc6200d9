package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import dev.twister.scene.property.TrackProperties;
import java.util.List;

/**
 * How a property of a part of a scene changes in a film. Before its first keyframe and after its last one the property
 * keeps their values, unless it loops.
 *
 * @param property its name, one of {@link TrackProperties#of}
 * @param keyframes at least one, each later than the one before
 * @param loop whether it begins again with the first keyframe at the time of the last one, and so on
 */
@Copied
public record Track(TrackTarget target, String property, List<Keyframe> keyframes, boolean loop)
        implements TrackCopy.With {
    /** No track of a scene; has the values of the fields that a file leaves out. */
    public static final Track DEFAULT = new Track(TrackTarget.CAMERA, "", List.of(), false);

    public Track {
        requireNonNull(target, "target");
        requireNonNull(property, "property");
        keyframes = List.copyOf(keyframes);
    }

    /** A track that does not loop. */
    public static Track of(TrackTarget target, String property, Keyframe... keyframes) {
        return new Track(target, property, List.of(keyframes), false);
    }

    /** Whether it is the track of that property. */
    public boolean isOf(TrackTarget other, String otherProperty) {
        return target.equals(other) && property.equals(otherProperty);
    }
}
