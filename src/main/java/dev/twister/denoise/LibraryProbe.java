package dev.twister.denoise;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Tries a library in a process of its own, because a library that crashes ends the process that loads it. The process
 * denoises a small picture and writes one line to a file: what the library itself prints may be endless, and a process
 * that the library started may keep a pipe open.
 */
final class LibraryProbe {
    private static final String WORKS = "works: ";
    private static final String REFUSED = "refused: ";
    private static final long MOST_SECONDS = 120;
    private static final long LOOK_MILLIS = 20;
    private static final int SIDE = 16;

    private LibraryProbe() {}

    /**
     * What a library is.
     *
     * @param version with the device, if it works
     * @param obstacle the rest of a sentence that begins with the library's name; empty if it works
     */
    record Result(String version, Optional<String> obstacle) {
        static Result refused(String obstacle) {
            return new Result("", Optional.of(obstacle));
        }
    }

    /** The process that is started: writes to the file that is named second whether the library works. */
    public static void main(String[] arguments) throws IOException {
        Files.writeString(Path.of(arguments[1]), line(arguments[0]));
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
            Path answer = Files.createTempFile("twister-denoiser-", ".txt");
            try {
                return tried(place, answer, mostSeconds);
            } finally {
                Files.deleteIfExists(answer);
            }
        } catch (IOException problem) {
            return Result.refused("was not tried, because no process could be started: " + problem);
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
            return Result.refused("was not tried to its end");
        }
    }

    private static Result tried(String place, Path answer, long mostSeconds) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(command(place, answer))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        // Not an argument, so that the system shows the whole command line, which names the answer.
        builder.environment().put("CLASSPATH", System.getProperty("java.class.path"));
        Process process = builder.start();
        Set<ProcessHandle> started = new HashSet<>();
        try {
            process.getOutputStream().close();
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(mostSeconds);
            boolean ended = false;
            while (!ended && System.nanoTime() < end) {
                process.descendants().forEach(started::add);
                ended = process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS);
            }
            return ended
                    ? result(Files.readString(answer), process.exitValue())
                    : Result.refused("did not denoise a small picture within " + mostSeconds + " s");
        } finally {
            endAll(process, started, answer);
        }
    }

    /**
     * Ends the process and those that the library started: descendants, which forget that they are once the process has
     * ended, and copies of the process, which have its command line.
     */
    private static void endAll(Process process, Set<ProcessHandle> started, Path answer) {
        Stream<ProcessHandle> copies = ProcessHandle.allProcesses()
                .filter(other -> other.info()
                        .commandLine()
                        .filter(line -> line.contains(answer.toString()))
                        .isPresent());
        Stream.of(Stream.of(process.toHandle()), process.descendants(), started.stream(), copies)
                .flatMap(handles -> handles)
                .forEach(ProcessHandle::destroyForcibly);
    }

    private static Result result(String said, int code) {
        if (said.startsWith(WORKS)) {
            return new Result(said.substring(WORKS.length()), Optional.empty());
        }
        return Result.refused(
                said.startsWith(REFUSED)
                        ? said.substring(REFUSED.length())
                        : "ended the process that tried it (exit code " + code + ")");
    }

    private static List<String> command(String place, Path answer) {
        return List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-XX:+SuppressFatalErrorMessage",
                "-XX:-CreateCoredumpOnCrash",
                "--enable-native-access=ALL-UNNAMED",
                LibraryProbe.class.getName(),
                place,
                answer.toString());
    }
}
