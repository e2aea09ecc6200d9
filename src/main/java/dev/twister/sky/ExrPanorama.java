package dev.twister.sky;

import dev.twister.exr.ExrBytes;
import dev.twister.exr.ExrColors;
import dev.twister.exr.OpenExrFile;
import dev.twister.sky.image.FileBytes;
import java.io.EOFException;
import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import java.util.zip.DataFormatException;

/** Reads OpenEXR panoramas. */
final class ExrPanorama {
    private static final String START = "v/1\u0001";

    private ExrPanorama() {}

    static boolean startsIn(FileBytes file) throws IOException {
        return file.startsWith(START);
    }

    /**
     * Reads a panorama. What is not finite or below 0 is no radiance, and counts as 0.
     *
     * @param warnings told of what is not used
     */
    static Skybox read(FileBytes file, Consumer<String> warnings) throws IOException {
        try {
            return read(new OpenExrFile(bytes(file)), warnings);
        } catch (EOFException incomplete) {
            throw new IOException("the OpenEXR file ends before its last row", incomplete);
        } catch (DataFormatException damage) {
            throw new IOException("a damaged OpenEXR file", damage);
        }
    }

    private static ExrBytes bytes(FileBytes file) {
        return new ExrBytes() {
            @Override
            public long length() {
                return file.length();
            }

            @Override
            public void copy(long position, byte[] target) throws IOException {
                file.copy(position, target, 0, target.length);
            }
        };
    }

    private static Skybox read(OpenExrFile exr, Consumer<String> warnings) throws IOException, DataFormatException {
        SkyboxLimits.checkSize(exr.width(), exr.height());
        exr.checkEmpty(exr.width(), exr.height());
        List<String> colors = ExrColors.of(exr.channels());
        if (colors.isEmpty()) {
            throw new IOException("an OpenEXR file without colors; it has " + String.join(", ", exr.channels()));
        }
        exr.firstPart().ifPresent(part -> warnings.accept("is more than what is read, " + part));
        List<float[]> channels = exr.read(colors);
        float[] radiance = new float[Math.multiplyExact(3, exr.width() * exr.height())];
        int first = exr.firstRow() * exr.width();
        int refused = 0;
        for (int channel = 0; channel < colors.size(); channel++) {
            float[] values = channels.get(channel);
            for (int i = 0; i < values.length; i++) {
                boolean light = values[i] >= 0 && values[i] <= Float.MAX_VALUE;
                refused += light ? 0 : 1;
                radiance[3 * (first + i) + channel] = light ? values[i] : 0;
            }
        }
        if (refused > 0) {
            warnings.accept(refused + " values are negative or not finite and count as 0");
        }
        return new Skybox(exr.width(), exr.height(), radiance);
    }
}
