package dev.twister.denoise;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Tries a library in a process of its own, because a library that crashes ends the process that loads it. The process
 * denoises a small picture and prints one line.
 */
final class LibraryProbe {
    private static final String WORKS = "works: ";
    private static final String REFUSED = "refused: ";
    private static final long MOST_SECONDS = 120;
    private static final int SIDE = 16;

    private LibraryProbe() {}

    /**
     * What a library is.
     *
     * @param version with the device, if it works
     * @param obstacle the rest of a sentence that begins with the library's name; empty if it works
     */
    record Result(String version, Optional<String> obstacle) {}

    /** The process that is started: prints whether the library works. */
    public static void main(String[] arguments) throws IOException {
        try (OutputStream out = new FileOutputStream(FileDescriptor.out)) {
            out.write(line(arguments[0]).getBytes(StandardCharsets.UTF_8));
        }
    }

    private static String line(String place) {
        try (OpenImageDenoise denoiser = open(place)) {
            float[] gray = new float[3 * SIDE * SIDE];
            denoiser.denoise(new NoisyPicture(SIDE, SIDE, new Plane(gray, 0), Optional.empty()));
            return WORKS + denoiser.text();
        } catch (DenoiseException problem) {
            return REFUSED + problem.getMessage();
        }
    }

    /** Opens a library in this process. */
    static OpenImageDenoise open(String place) {
        return new OpenImageDenoise(new OidnDevice(new OidnFunctions(place)));
    }

    /** Tries a library in another process. */
    static Result of(String place) {
        return of(place, MOST_SECONDS);
    }

    /** As above, with another time limit. */
    static Result of(String place, long mostSeconds) {
        try {
            Process process = new ProcessBuilder(command(place))
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            process.getOutputStream().close();
            AtomicBoolean late = new AtomicBoolean();
            process.onExit().orTimeout(mostSeconds, TimeUnit.SECONDS).exceptionally(_ -> {
                late.set(true);
                return process.destroyForcibly();
            });
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            int code = process.waitFor();
            return late.get()
                    ? new Result("", Optional.of("did not denoise a small picture within " + mostSeconds + " s"))
                    : result(said, code);
        } catch (IOException problem) {
            return new Result("", Optional.of("was not tried, because no process could be started: " + problem));
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return new Result("", Optional.of("was not tried to its end"));
        }
    }

    private static Result result(String said, int code) {
        String last = said.lines().reduce("", (_, line) -> line);
        if (last.startsWith(WORKS)) {
            return new Result(last.substring(WORKS.length()), Optional.empty());
        }
        return new Result(
                "",
                Optional.of(
                        last.startsWith(REFUSED)
                                ? last.substring(REFUSED.length())
                                : "ended the process that tried it (exit code " + code + ")"));
    }

    private static List<String> command(String place) {
        return List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-XX:+SuppressFatalErrorMessage",
                "-XX:-CreateCoredumpOnCrash",
                "--enable-native-access=ALL-UNNAMED",
                "-cp",
                System.getProperty("java.class.path"),
                LibraryProbe.class.getName(),
                place);
    }
}
