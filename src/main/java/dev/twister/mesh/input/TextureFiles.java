package dev.twister.mesh.input;

import dev.twister.files.GitLfs;
import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.mesh.MeshException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.ClosedByInterruptException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;

/** Texture files that a mesh file refers to. */
public final class TextureFiles {
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G'};
    private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd8, (byte) 0xff};
    private static final byte[] RIFF = {'R', 'I', 'F', 'F'};
    private static final byte[] WEBP = {'W', 'E', 'B', 'P'};
    private static final int WEBP_AT = 8;
    private static final byte[] GIT_LFS = GitLfs.START.getBytes(StandardCharsets.US_ASCII);
    private static final String WITHOUT = "; rendered without it";

    private TextureFiles() {}

    /**
     * A texture by its name in a file; empty, with a warning, if it is not beside the file, cannot be read or is
     * neither PNG, JPEG nor WebP.
     *
     * @param file the referring file
     */
    public static Optional<Path> beside(Path file, String name, Warnings warnings) throws IOException {
        try {
            Path texture = PathsBeside.of(file, name, MeshException::new);
            checkFile(texture);
            return Optional.of(texture);
        } catch (ClosedByInterruptException canceled) {
            throw canceled;
        } catch (MeshException problem) {
            warnings.add("texture: " + problem.getMessage() + WITHOUT);
        } catch (IOException problem) {
            warnings.add("texture " + QuotedText.text(name) + ": " + SystemReason.of(problem) + WITHOUT);
        }
        return Optional.empty();
    }

    private static void checkFile(Path texture) throws IOException {
        InputFile.check(texture);
        try (InputStream in = Files.newInputStream(texture)) {
            check(in.readNBytes(GIT_LFS.length));
        }
    }

    /**
     * Checks that bytes start with the signature of PNG, JPEG or WebP.
     *
     * @throws IOException that says what they are instead
     */
    public static void check(byte[] bytes) throws IOException {
        if (startsWith(bytes, GIT_LFS)) {
            throw new IOException(GitLfs.PROBLEM);
        }
        if (!startsWith(bytes, PNG) && !startsWith(bytes, JPEG) && !isWebp(bytes)) {
            throw new IOException("neither PNG, JPEG nor WebP");
        }
    }

    private static boolean isWebp(byte[] bytes) {
        int end = WEBP_AT + WEBP.length;
        return startsWith(bytes, RIFF)
                && bytes.length >= end
                && Arrays.equals(bytes, WEBP_AT, end, WEBP, 0, WEBP.length);
    }

    private static boolean startsWith(byte[] bytes, byte[] start) {
        return bytes.length >= start.length && Arrays.equals(bytes, 0, start.length, start, 0, start.length);
    }
}
