package dev.twister.sky.image;

import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/** Reads the bytes of a sky file as the reader reads files. */
public final class SkyBytes {
    private SkyBytes() {}

    public static Skybox read(byte[] file) throws IOException {
        return read(file, new ArrayList<>());
    }

    public static Skybox read(byte[] file, List<String> warnings) throws IOException {
        Path path = Files.createTempFile("sky", ".bytes");
        Files.write(path, file);
        try (FileChannel channel =
                FileChannel.open(path, StandardOpenOption.READ, StandardOpenOption.DELETE_ON_CLOSE)) {
            return SkyboxReader.decode(new FileBytes(channel), warnings::add);
        }
    }
}
