package dev.twister.denoise;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.URISyntaxException;
import java.net.UnixDomainSocketAddress;
import java.nio.FloatBuffer;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A library in a process of its own, {@link OidnServer}, which ends when something fails. Messages of exceptions
 * continue the library's name.
 */
final class OidnProcess implements AutoCloseable {
    private static final long LOOK_MILLIS = 50;
    private static final long END_MILLIS = 2000;

    private final Path folder;
    private final ServerSocketChannel server;
    private final Process process;
    private final String version;
    private volatile Optional<FloatChannel> channel = Optional.empty();
    private volatile boolean late;

    /** Those that the library started: they forget that they are descendants once the process has ended. */
    private final Set<ProcessHandle> started = ConcurrentHashMap.newKeySet();

    /** Something that the process is asked, and that it answers. */
    private interface Exchange<T> {
        T result() throws IOException;
    }

    /**
     * Starts the process.
     *
     * @param place the library's file, or a name for the system's loader
     * @param mostSeconds limit of the time until it has denoised a small picture
     * @throws DenoiseException if the library does not work
     */
    OidnProcess(String place, long mostSeconds) {
        try {
            folder = Files.createTempDirectory("twister-denoiser-");
            server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
        } catch (IOException problem) {
            throw notStarted(problem);
        }
        try {
            server.bind(UnixDomainSocketAddress.of(socket()));
            process = start(place);
        } catch (IOException problem) {
            closeChannels();
            deleteFolder();
            throw notStarted(problem);
        }
        CompletableFuture<Void> _ = process.onExit().thenRun(this::closeChannels);
        version = asked(mostSeconds, () -> {
            FloatChannel connected = new FloatChannel(server.accept());
            channel = Optional.of(connected);
            requireSuccess(connected);
            return connected.readText();
        });
    }

    private static DenoiseException notStarted(IOException problem) {
        return new DenoiseException("was not tried, because no process could be started: " + problem, problem);
    }

    /** Version and device, for display. */
    String version() {
        return version;
    }

    /**
     * Denoises rows of a picture.
     *
     * @param planes radiance, albedo and normal of all rows
     * @param denoised filled with the rows that are asked for
     * @param mostSeconds limit of the time
     * @throws DenoiseException if the library fails, does not answer, or if the thread is interrupted
     */
    void denoise(OidnServer.Request request, List<FloatBuffer> planes, FloatBuffer denoised, long mostSeconds) {
        FloatBuffer _ = asked(mostSeconds, () -> {
            FloatChannel connected = channel.orElseThrow();
            request.write(connected);
            for (FloatBuffer plane : planes) {
                connected.writeFinite(plane);
            }
            requireSuccess(connected);
            connected.read(denoised);
            return denoised;
        });
    }

    private static void requireSuccess(FloatChannel connected) throws IOException {
        if (connected.readInt() == OidnServer.REFUSED) {
            throw new DenoiseException(connected.readText());
        }
    }

    private <T> T asked(long mostSeconds, Exchange<T> exchange) {
        Thread watching = Thread.ofVirtual().start(() -> watch(mostSeconds));
        try {
            return exchange.result();
        } catch (DenoiseException refused) {
            close();
            throw refused;
        } catch (ClosedByInterruptException interrupted) {
            close();
            throw new DenoiseException("was stopped", interrupted);
        } catch (IOException problem) {
            String end = late ? "did not answer within " + mostSeconds + " s" : "ended its process" + exitCode();
            close();
            throw new DenoiseException(end, problem);
        } finally {
            watching.interrupt();
        }
    }

    /** Runs while the process is asked something. */
    private void watch(long mostSeconds) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(mostSeconds);
        try {
            while (System.nanoTime() < end) {
                process.descendants().forEach(started::add);
                Thread.sleep(LOOK_MILLIS);
            }
            late = true;
            close();
        } catch (InterruptedException _) {
            // It has answered.
        }
    }

    private String exitCode() {
        try {
            return process.waitFor(END_MILLIS, TimeUnit.MILLISECONDS) ? " (exit code " + process.exitValue() + ")" : "";
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
            return "";
        }
    }

    private Path socket() {
        return folder.resolve("socket");
    }

    private Process start(String place) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-XX:+UseSerialGC",
                        "-XX:+SuppressFatalErrorMessage",
                        "-XX:-CreateCoredumpOnCrash",
                        "--enable-native-access=ALL-UNNAMED",
                        OidnServer.class.getName(),
                        place,
                        socket().toString())
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        // Not an argument, so that the system shows the whole command line, which names the socket.
        builder.environment().put("CLASSPATH", ownPlace());
        Process begun = builder.start();
        begun.getOutputStream().close();
        return begun;
    }

    /** This program's jar or folder, also where it is a module. */
    private static String ownPlace() throws IOException {
        try {
            return Path.of(OidnServer.class
                            .getProtectionDomain()
                            .getCodeSource()
                            .getLocation()
                            .toURI())
                    .toString();
        } catch (URISyntaxException problem) {
            throw new IOException(problem);
        }
    }

    /** Ends the process, what the library started, and copies of the process, which have its command line. */
    @Override
    public void close() {
        closeChannels();
        Stream<ProcessHandle> copies = ProcessHandle.allProcesses()
                .filter(other -> other.info()
                        .commandLine()
                        .filter(line -> line.contains(folder.toString()))
                        .isPresent());
        Stream.of(process.descendants(), Stream.of(process.toHandle()), started.stream(), copies)
                .flatMap(handles -> handles)
                .forEach(ProcessHandle::destroyForcibly);
        deleteFolder();
    }

    private void deleteFolder() {
        try {
            Files.deleteIfExists(socket());
            Files.deleteIfExists(folder);
        } catch (IOException _) {
            // An empty folder for temporary files stays.
        }
    }

    private void closeChannels() {
        try {
            server.close();
            if (channel.isPresent()) {
                channel.get().close();
            }
        } catch (IOException _) {
            // Nothing is read from it any more.
        }
    }
}
