package dev.twister.film;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The program ffmpeg, which encodes MP4 films in H.264 with 4:2:0 chroma, which all players support, tagged with
 * BT.709's primaries and matrix and the sRGB transfer function.
 *
 * @param program the executable file
 */
public record Ffmpeg(Path program) {
    private static final List<String> NAMES = List.of("ffmpeg", "ffmpeg.exe");

    /** The first ffmpeg on a search path. */
    public static Optional<Ffmpeg> find(String path) {
        return Arrays.stream(path.split(Pattern.quote(File.pathSeparator)))
                .filter(folder -> !folder.isEmpty())
                .flatMap(folder -> NAMES.stream().flatMap(name -> path(folder, name).stream()))
                .filter(Files::isExecutable)
                .filter(Files::isRegularFile)
                .findFirst()
                .map(Ffmpeg::new);
    }

    /** Empty for an entry that is no path on this system, such as one in quotation marks on Windows. */
    private static Optional<Path> path(String folder, String name) {
        try {
            return Optional.of(Path.of(folder, name));
        } catch (InvalidPathException _) {
            return Optional.empty();
        }
    }

    /**
     * Begins a film. An odd last column or row is left out, as 4:2:0 chroma needs even sides.
     *
     * @throws IOException if the frames are too small, the file cannot be written, or ffmpeg cannot be started
     */
    FilmEncoder begin(Path file, FilmFormat format) throws IOException {
        if (format.width() < 2 || format.height() < 2) {
            throw new IOException("cannot write " + file + ": frames of " + format.width() + " x " + format.height()
                    + " pixels are too small for H.264, which needs 2 x 2 or more; give an .apng file");
        }
        return FfmpegFilm.begin(this, file, format);
    }

    /** The command that reads frames as bytes B, G, R, A from its standard input. */
    List<String> command(Path film, FilmFormat format) {
        return List.of(
                program.toString(),
                "-hide_banner",
                "-loglevel",
                "error",
                "-nostdin",
                "-xerror",
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
                "-f",
                "mp4",
                "-y",
                film.toString());
    }
}
