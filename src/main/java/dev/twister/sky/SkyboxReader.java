package dev.twister.sky;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Reads panoramas: Radiance pictures ({@code .hdr}, {@code .pic}), PNG and JPEG, told apart by their first bytes, whatever
 * their names end in.
 */
public final class SkyboxReader {
    private SkyboxReader() {}

    /**
     * Reads a panorama of at most 16384 x 8192 texels from a file of at most 1 GiB. Radiance pictures keep radiance above
     * 1; PNG and JPEG are taken as sRGB and made linear, 0 to 1, over black where they are transparent.
     *
     * @param file a file of the default file system
     * @throws SkyException where there is no such file, it is not a panorama of these kinds, is damaged or too large
     */
    public static Skybox read(Path file) {
        try {
            return readFile(file);
        } catch (AccessDeniedException denied) {
            throw new SkyException(file + ": no permission to read it", denied);
        } catch (IOException problem) {
            throw new SkyException(file + ": " + problem.getMessage(), problem);
        }
    }

    private static Skybox readFile(Path file) throws IOException {
        if (!Files.exists(file)) {
            throw new IOException("there is no such file");
        }
        if (!Files.isRegularFile(file)) {
            throw new IOException("not a file but a folder or a device");
        }
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ);
                Arena arena = Arena.ofConfined()) {
            long length = channel.size();
            if (length > SkyboxLimits.FILE_BYTES) {
                throw new IOException(length + " bytes; at most " + SkyboxLimits.FILE_BYTES + " are allowed");
            }
            // An arena, unlike the garbage collector, gives the file back as soon as it has been read.
            ByteBuffer content =
                    channel.map(FileChannel.MapMode.READ_ONLY, 0, length, arena).asByteBuffer();
            return decode(content);
        }
    }

    /** What is in a mapped file, which may be written to meanwhile. */
    static Skybox decode(ByteBuffer content) throws IOException {
        try {
            return decodeByKind(content);
        } catch (InternalError gone) {
            // So the JVM says that the file has become shorter than what is mapped of it.
            throw new IOException("it was changed while it was read; try again", gone);
        }
    }

    private static Skybox decodeByKind(ByteBuffer content) throws IOException {
        if (RadianceHeader.startsIn(content)) {
            return RadianceReader.read(content);
        }
        for (OrdinaryImageFormat format : OrdinaryImageFormat.values()) {
            if (format.startsIn(content)) {
                return OrdinaryImageReader.read(content, format);
            }
        }
        throw new IOException((content.hasRemaining() ? "not a panorama by its first bytes" : "an empty file")
                + "; Radiance (#?RADIANCE or #?RGBE), PNG and JPEG are read");
    }
}
