package dev.twister.film;

import dev.twister.files.SystemReason;
import dev.twister.files.WholeFile;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The program ffmpeg, which makes MP4 films of H.264: 4:2:0 chroma, as all players take it, BT.709's primaries and
 * matrix and the sRGB transfer function, all tagged.
 *
 * @param program its file
 */
public record Ffmpeg(Path program) {
    private static final List<String> NAMES = List.of("ffmpeg", "ffmpeg.exe");

    /** The first one on a search path. */
    public static Optional<Ffmpeg> find(String path) {
        return Arrays.stream(path.split(Pattern.quote(File.pathSeparator)))
                .filter(folder -> !folder.isEmpty())
                .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .filter(Files::isRegularFile)
                .findFirst()
                .map(Ffmpeg::new);
    }

    /**
     * Writes a film, whole or not at all. An odd last column or row is left out, as 4:2:0 chroma needs even sides.
     *
     * @throws IOException where ffmpeg fails, with its own last words; as {@link WholeFile#write}; or what the source
     *     has thrown
     */
    public void write(Path file, FilmFormat format, FrameSource source) throws IOException {
        Path folder = Files.createTempDirectory("twister-film");
        Path film = folder.resolve("film.mp4");
        Path log = folder.resolve("ffmpeg.log");
        try {
            encode(film, log, format, source);
            WholeFile.write(file, out -> Files.copy(film, out));
        } finally {
            try (Stream<Path> files = Files.list(folder)) {
                files.forEach(Ffmpeg::delete);
            }
            delete(folder);
        }
    }

    private void encode(Path film, Path log, FilmFormat format, FrameSource source) throws IOException {
        Process process = new ProcessBuilder(command(film, format))
                .redirectErrorStream(true)
                .redirectOutput(log.toFile())
                .start();
        boolean fed = false;
        try {
            feed(process.getOutputStream(), format, source);
            fed = true;
        } finally {
            close(process.getOutputStream());
            if (!fed) {
                process.destroy();
            }
        }
        if (exitCode(process) != 0) {
            throw new IOException(program + " failed: " + lastLine(log));
        }
    }

    private static void feed(OutputStream in, FilmFormat format, FrameSource source) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(Math.multiplyExact(Integer.BYTES, format.width() * format.height()))
                .order(ByteOrder.LITTLE_ENDIAN);
        boolean taken = true;
        for (int frame = 0; frame < format.frames() && taken; frame++) {
            bytes.asIntBuffer().put(source.next());
            taken = isTaken(in, bytes.array());
        }
    }

    private static boolean isTaken(OutputStream in, byte[] frame) {
        try {
            in.write(frame);
            return true;
        } catch (IOException _) {
            return false;
        }
    }

    private static void close(OutputStream in) {
        try {
            in.close();
        } catch (IOException _) {
            // ffmpeg has ended early. Its exit code tells, and its log says why.
        }
    }

    private static int exitCode(Process process) throws IOException {
        try {
            return process.waitFor();
        } catch (InterruptedException interrupted) {
            process.destroy();
            Thread.currentThread().interrupt();
            throw new IOException("interrupted while ffmpeg encoded", interrupted);
        }
    }

    private static String lastLine(Path log) throws IOException {
        return Files.readAllLines(log, Charset.defaultCharset()).stream()
                .filter(line -> !line.isBlank())
                .reduce((_, last) -> last)
                .orElse("it said nothing");
    }

    private static void delete(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException problem) {
            throw new UncheckedIOException(
                    new IOException("cannot delete " + file + ": " + SystemReason.of(problem), problem));
        }
    }

    private List<String> command(Path film, FilmFormat format) {
        return List.of(
                program.toString(),
                "-hide_banner",
                "-loglevel",
                "error",
                "-nostdin",
                "-f",
                "rawvideo",
                "-pixel_format",
                "bgra",
                "-video_size",
                format.width() + "x" + format.height(),
                "-framerate",
                Double.toString(format.rate()),
                "-i",
                "pipe:0",
                "-vf",
                "crop=trunc(iw/2)*2:trunc(ih/2)*2,"
                        + "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p,"
                        + "setparams=range=tv:color_primaries=bt709:color_trc=iec61966-2-1:colorspace=bt709",
                "-c:v",
                "libx264",
                "-crf",
                "18",
                "-pix_fmt",
                "yuv420p",
                "-color_primaries",
                "bt709",
                "-color_trc",
                "iec61966-2-1",
                "-colorspace",
                "bt709",
                "-color_range",
                "tv",
                "-movflags",
                "+faststart",
                "-y",
                film.toString());
    }
}
