package dev.twister.image;

import java.util.Optional;

/**
 * What a picture's file says of how it was made.
 *
 * @param software the program with its version
 * @param picture a digest of everything that the picture depends on but its samples; one word
 * @param samples of each pixel, such as {@code 16} or {@code 0-15}
 */
public record Provenance(String software, String picture, String samples) {
    /** The digest and the samples under this name; the software under {@link #SOFTWARE}. */
    static final String NAME = "Twister";

    static final String SOFTWARE = "Software";

    String text() {
        return picture + " " + samples;
    }

    static Optional<Provenance> of(String software, String text) {
        int end = text.indexOf(' ');
        return end < 0
                ? Optional.empty()
                : Optional.of(new Provenance(software, text.substring(0, end), text.substring(end + 1)));
    }
}
