package dev.twister.film;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
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
                .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .filter(Files::isRegularFile)
                .findFirst()
                .map(Ffmpeg::new);
    }

    /**
     * Begins a film. An odd last column or row is left out, as 4:2:0 chroma needs even sides.
     *
     * @throws IOException if the file cannot be written, or ffmpeg cannot be started
     */
    FilmEncoder begin(Path file, FilmFormat format) throws IOException {
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
