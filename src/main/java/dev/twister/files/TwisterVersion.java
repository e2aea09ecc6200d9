package dev.twister.files;

import java.util.Optional;

/** Which Twister this is. */
public final class TwisterVersion {
    private TwisterVersion() {}

    /** The jar's version; {@code development} where it runs from classes. */
    public static String text() {
        return Optional.ofNullable(TwisterVersion.class.getPackage().getImplementationVersion())
                .orElse("development");
    }
}
