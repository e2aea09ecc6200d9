package dev.twister.sky;

import dev.twister.files.GitLfs;
import dev.twister.files.InputFile;
import dev.twister.sky.image.FileBytes;
import dev.twister.sky.image.LinearImage;
import dev.twister.sky.image.OrdinaryImageFormat;
import dev.twister.sky.image.OrdinaryImageReader;
import dev.twister.sky.image.WebpFile;
import dev.twister.sky.radiance.RadianceHeader;
import dev.twister.sky.radiance.RadianceReader;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Reads panoramas: Radiance pictures ({@code .hdr}, {@code .pic}), OpenEXR, PNG, JPEG and WebP, told apart by their
 * first bytes, whatever their names end in.
 */
public final class SkyboxReader {
    /** Radiance of the sky of a scene that names none. */
    private static final float LIGHT_GRAY = 0.8f;

    /** What a file's bytes are made a picture by. */
    interface Decoder<T> {
        T decode(FileBytes file, Consumer<String> warnings) throws IOException;
    }

    private SkyboxReader() {}

    /**
     * Reads a panorama as {@link #read(Path, Consumer)} does, and says nothing of what is not used.
     *
     * @param file a file of the default file system
     * @throws SkyException where there is no such file, it is not a panorama of these kinds, is damaged or too large
     */
    public static Skybox read(Path file) {
        return read(file, _ -> {});
    }

    /**
     * Reads a panorama of at most 16384 x 8192 texels from a file of at most 1 GiB. Radiance and OpenEXR pictures keep
     * radiance above 1. PNG, JPEG and WebP are made linear, 0 to 1, by what they say of their colors, as sRGB where
     * they say nothing, over black where they are transparent, and turned upright by their EXIF orientation.
     *
     * @param file a file of the default file system; an empty path is a light gray sky
     * @param warnings told of what the file says and is not used; one line each that names the file
     * @throws SkyException where there is no such file, it is not a panorama of these kinds, is damaged or too large
     */
    public static Skybox read(Path file, Consumer<String> warnings) {
        return file.toString().isEmpty() ? Skybox.uniform(LIGHT_GRAY) : read(file, warnings, SkyboxReader::decode);
    }

    public static <T> T read(Path file, Consumer<String> warnings, Decoder<T> decoder) {
        try {
            return readFile(file, warning -> warnings.accept(file + ": " + warning), decoder);
        } catch (AccessDeniedException denied) {
            throw new SkyException(file + ": no permission to read it", denied);
        } catch (IOException problem) {
            throw new SkyException(file + ": " + problem.getMessage(), problem);
        }
    }

    private static <T> T readFile(Path file, Consumer<String> warnings, Decoder<T> decoder) throws IOException {
        InputFile.check(file);
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            long length = channel.size();
            if (length > SkyboxLimits.FILE_BYTES) {
                throw new IOException(length + " bytes; at most " + SkyboxLimits.FILE_BYTES + " are allowed");
            }
            return decoder.decode(new FileBytes(channel), warnings);
        }
    }

    public static Skybox decode(FileBytes file, Consumer<String> warnings) throws IOException {
        if (RadianceHeader.startsIn(file)) {
            return RadianceReader.read(file);
        }
        if (ExrPanorama.startsIn(file)) {
            return ExrPanorama.read(file, warnings);
        }
        Optional<Skybox> ordinary = decodeOrdinary(file, LinearImage::skybox, warnings);
        if (ordinary.isEmpty()) {
            throw unknown(file, "panorama", "Radiance, OpenEXR, PNG, JPEG and WebP");
        }
        return ordinary.get();
    }

    /** The picture of a PNG, JPEG or WebP; empty where the first bytes are of none. */
    static <T> Optional<T> decodeOrdinary(
            FileBytes file, OrdinaryImageReader.Conversion<T> conversion, Consumer<String> warnings)
            throws IOException {
        if (WebpFile.startsIn(file)) {
            return Optional.of(WebpFile.read(file, conversion, warnings));
        }
        for (OrdinaryImageFormat format : OrdinaryImageFormat.values()) {
            if (format.startsIn(file)) {
                return Optional.of(OrdinaryImageReader.read(file, format, conversion, warnings));
            }
        }
        return Optional.empty();
    }

    /** Says that a file's first bytes are of no kind that is read. */
    static IOException unknown(FileBytes file, String wanted, String kinds) throws IOException {
        if (file.startsWith(GitLfs.START)) {
            return new IOException(GitLfs.PROBLEM);
        }
        return new IOException((file.length() > 0 ? "not a " + wanted + " by its first bytes" : "an empty file") + "; "
                + kinds + " are read");
    }
}
