package dev.twister.film;

import dev.twister.files.FileReplacement;
import dev.twister.files.WholeFile;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;

/** A film that ffmpeg encodes; its file is checked before it takes its name. */
final class FfmpegFilm implements FilmEncoder {
    private final Ffmpeg ffmpeg;
    private final Path file;
    private final FilmFormat format;
    private final FileReplacement replacement;
    private final Process process;
    private final CompletableFuture<String> lastLine = new CompletableFuture<>();
    private final ByteBuffer frame;
    private final Thread hook = Thread.ofPlatform().name("end of ffmpeg").unstarted(this::end);

    private FfmpegFilm(Ffmpeg ffmpeg, Path file, FilmFormat format, FileReplacement replacement) throws IOException {
        this.ffmpeg = ffmpeg;
        this.file = file;
        this.format = format;
        this.replacement = replacement;
        frame = ByteBuffer.allocate(Math.multiplyExact(Integer.BYTES, format.width() * format.height()))
                .order(ByteOrder.LITTLE_ENDIAN);
        replacement.share();
        process = new ProcessBuilder(ffmpeg.command(replacement.path(), format))
                .redirectErrorStream(true)
                .start();
        Thread.ofPlatform().name("ffmpeg's messages").daemon().start(this::readMessages);
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException _) {
            end();
        }
    }

    static FfmpegFilm begin(Ffmpeg ffmpeg, Path file, FilmFormat format) throws IOException {
        FileReplacement replacement;
        try {
            replacement = FileReplacement.of(file);
        } catch (IOException failure) {
            throw WholeFile.explained(file, failure);
        }
        try {
            return new FfmpegFilm(ffmpeg, file, format, replacement);
        } catch (IOException | RuntimeException failure) {
            replacement.close();
            throw failure;
        }
    }

    private void readMessages() {
        String last = "";
        try (BufferedReader messages = process.inputReader()) {
            for (String line = messages.readLine(); line != null; line = messages.readLine()) {
                if (!line.isBlank() && !line.startsWith("    Last message repeated")) {
                    last = line.strip();
                }
            }
        } catch (IOException _) {
            // The process ended; what was read before counts.
        } finally {
            lastLine.complete(last);
        }
    }

    @Override
    public void add(int[] argb) throws IOException {
        frame.asIntBuffer().put(argb);
        try {
            process.getOutputStream().write(frame.array());
            process.getOutputStream().flush();
        } catch (IOException closed) {
            // The exit code and ffmpeg's messages tell why.
            throw failure(exitCode());
        }
    }

    @Override
    public void finish() throws IOException {
        closeInput();
        int exitCode = exitCode();
        if (exitCode != 0) {
            throw failure(exitCode);
        }
        try {
            Mp4File.check(replacement.channel(), format);
        } catch (IOException damage) {
            throw new IOException(
                    "cannot write " + file + ": " + ffmpeg.program() + " left an incomplete film: "
                            + damage.getMessage() + said(),
                    damage);
        }
        try {
            replacement.finish();
        } catch (IOException failure) {
            throw WholeFile.explained(file, failure);
        }
    }

    private void closeInput() {
        try (OutputStream in = process.getOutputStream()) {
            in.flush();
        } catch (IOException _) {
            // ffmpeg ended early: the exit code and its messages tell why.
        }
    }

    private int exitCode() throws IOException {
        try {
            return process.waitFor();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted while ffmpeg encoded", interrupted);
        }
    }

    private IOException failure(int exitCode) {
        return new IOException(
                "cannot write " + file + ": " + ffmpeg.program() + " ended with exit code " + exitCode + said());
    }

    /** ffmpeg's last message, with the film's own name in place of the temporary one. */
    private String said() {
        String line = lastLine.join();
        return line.isEmpty() ? "" : ": " + line.replace(replacement.path().toString(), file.toString());
    }

    /** The process ends: ffmpeg, which may create its file late, must not outlive it. */
    private void end() {
        try {
            process.destroyForcibly().onExit().join();
            Files.deleteIfExists(replacement.path());
        } catch (IOException _) {
            // Deleted as a leftover by the next process that writes there.
        }
    }

    @Override
    public void close() throws IOException {
        process.destroyForcibly();
        closeInput();
        process.onExit().join();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException _) {
            // The process ends: the hook finds nothing to delete.
        }
        replacement.close();
    }
}
