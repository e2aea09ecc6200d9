package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.lwjgl.util.tinyexr.TinyEXR.FreeEXRHeader;
import static org.lwjgl.util.tinyexr.TinyEXR.FreeEXRImage;
import static org.lwjgl.util.tinyexr.TinyEXR.InitEXRHeader;
import static org.lwjgl.util.tinyexr.TinyEXR.InitEXRImage;
import static org.lwjgl.util.tinyexr.TinyEXR.LoadEXRImageFromMemory;
import static org.lwjgl.util.tinyexr.TinyEXR.ParseEXRHeaderFromMemory;
import static org.lwjgl.util.tinyexr.TinyEXR.ParseEXRVersionFromMemory;
import static org.lwjgl.util.tinyexr.TinyEXR.TINYEXR_SUCCESS;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.lwjgl.PointerBuffer;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.util.tinyexr.EXRHeader;
import org.lwjgl.util.tinyexr.EXRImage;
import org.lwjgl.util.tinyexr.EXRVersion;

/** An OpenEXR file as read by TinyEXR: each channel's floats in row-major order from the top. */
public record ExrFile(int width, int height, Map<String, float[]> channels) {
    public static ExrFile read(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        ByteBuffer memory = MemoryUtil.memAlloc(bytes.length).put(bytes).flip();
        try (MemoryStack stack = MemoryStack.stackPush()) {
            PointerBuffer problem = stack.callocPointer(1);
            EXRVersion version = EXRVersion.calloc(stack);
            EXRHeader header = EXRHeader.calloc(stack);
            EXRImage image = EXRImage.calloc(stack);
            InitEXRHeader(header);
            InitEXRImage(image);
            require(ParseEXRVersionFromMemory(version, memory), problem);
            require(ParseEXRHeaderFromMemory(header, version, memory, problem), problem);
            require(LoadEXRImageFromMemory(image, header, memory, problem), problem);
            Map<String, float[]> channels = new TreeMap<>();
            for (int channel = 0; channel < header.num_channels(); channel++) {
                float[] values = new float[image.width() * image.height()];
                image.images().getFloatBuffer(channel, values.length).get(values);
                channels.put(header.channels().get(channel).nameString(), values);
            }
            ExrFile read = new ExrFile(image.width(), image.height(), channels);
            FreeEXRImage(image);
            FreeEXRHeader(header);
            return read;
        } finally {
            MemoryUtil.memFree(memory);
        }
    }

    private static void require(int result, PointerBuffer problem) {
        assertThat(result)
                .as(() -> problem.get(0) == 0 ? "TinyEXR" : MemoryUtil.memUTF8(problem.get(0)))
                .isEqualTo(TINYEXR_SUCCESS);
    }
}
