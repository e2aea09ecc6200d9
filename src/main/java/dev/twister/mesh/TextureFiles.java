package dev.twister.mesh;

import dev.twister.files.InputFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;

/** Texture files that a mesh file refers to. */
final class TextureFiles {
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G'};
    private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd8, (byte) 0xff};

    private TextureFiles() {}

    /** The file itself; empty, with a warning, if it does not exist or is neither PNG nor JPEG. */
    static Optional<Path> usable(Path texture, Warnings warnings) throws IOException {
        String name = "texture " + Shown.path(texture);
        Optional<String> problem = InputFile.problem(texture);
        if (problem.isPresent()) {
            warnings.add(name + ": " + problem.get() + "; rendered without it");
            return Optional.empty();
        }
        byte[] start;
        try (InputStream in = Files.newInputStream(texture)) {
            start = in.readNBytes(PNG.length);
        }
        if (!isPicture(start)) {
            warnings.add(name + ": neither PNG nor JPEG; rendered without it");
            return Optional.empty();
        }
        return Optional.of(texture);
    }

    /** Whether bytes start with the signature of PNG or JPEG. */
    static boolean isPicture(byte[] bytes) {
        return startsWith(bytes, PNG) || startsWith(bytes, JPEG);
    }

    private static boolean startsWith(byte[] bytes, byte[] start) {
        return bytes.length >= start.length && Arrays.equals(bytes, 0, start.length, start, 0, start.length);
    }
}
