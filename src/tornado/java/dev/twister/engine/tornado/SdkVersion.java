package dev.twister.engine.tornado;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The version of TornadoVM's SDK, and whether Twister was tested with it. */
record SdkVersion(int major, int minor, String text) {
    private static final int TESTED_MAJOR = 5;
    private static final int TESTED_MINOR = 2;

    private static final Pattern LINE =
            Pattern.compile("^version=((\\d{1,6})\\.(\\d{1,6})[\\w.+-]*)\\s*$", Pattern.MULTILINE);

    /** The version in the folder that {@code TORNADOVM_HOME} names; empty if it is not said there. */
    static Optional<SdkVersion> installed() {
        return Optional.ofNullable(System.getenv("TORNADOVM_HOME")).flatMap(home -> of(Path.of(home)));
    }

    /** The version of the SDK in a folder; empty if it is not said there. */
    static Optional<SdkVersion> of(Path sdk) {
        try {
            Matcher line = LINE.matcher(Files.readString(sdk.resolve("etc/tornado.release")));
            return line.find()
                    ? Optional.of(new SdkVersion(
                            Integer.parseInt(line.group(2)), Integer.parseInt(line.group(3)), line.group(1)))
                    : Optional.empty();
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** A warning if the SDK is newer than what was tested. */
    Optional<String> warning() {
        boolean newer = major > TESTED_MAJOR || (major == TESTED_MAJOR && minor > TESTED_MINOR);
        return newer
                ? Optional.of("TornadoVM " + text + " has not been tested; the newest tested version is " + TESTED_MAJOR
                        + "." + TESTED_MINOR + ". Compare pictures: twister devices --check")
                : Optional.empty();
    }
}
