package dev.twister.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads files of Twister's own, in whose place there may be anything by now. */
public final class SmallFile {
    private SmallFile() {}

    /**
     * Reads a file whole.
     *
     * @throws IOException where it cannot be read, is larger than that, or is a pipe or a device, which could block or
     *     never end
     */
    public static byte[] read(Path file, int mostBytes) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException("not a regular file");
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(mostBytes + 1);
            if (bytes.length > mostBytes) {
                throw new IOException("more than " + mostBytes + " bytes");
            }
            return bytes;
        }
    }
}
