package dev.twister.scene.material;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.Rgb;
import dev.twister.scene.property.Copied;
import java.util.Optional;

/**
 * What light loses inside a transmitting body: after the distance, {@code color} is left of white light (Beer's law).
 *
 * @param color in [0, 1] per channel
 * @param distance in meters, above 0; without one nothing is lost
 */
@Copied
public record Attenuation(Rgb color, Optional<Double> distance) implements AttenuationCopy.With {
    public static final Attenuation NONE = new Attenuation(new Rgb(1, 1, 1), Optional.empty());

    public Attenuation {
        requireNonNull(color, "color");
        requireNonNull(distance, "distance");
    }

    public Attenuation withDistance(double newDistance) {
        return withDistance(Optional.of(newDistance));
    }
}
