package dev.twister.render;

import dev.twister.image.ExrPicture;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrWriter;
import dev.twister.image.HdrWriter;
import dev.twister.image.PngWriter;
import dev.twister.image.Provenance;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Formats of picture files. */
public enum PictureFormat {
    PNG(".png"),
    HDR(".hdr"),
    EXR(".exr");

    private final String ending;

    PictureFormat(String ending) {
        this.ending = ending;
    }

    /** The format by the ending of a file's name. */
    public static Optional<PictureFormat> of(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return Arrays.stream(values())
                .filter(format -> name.endsWith(format.ending))
                .findFirst();
    }

    /** The ending with its dot. */
    public String ending() {
        return ending;
    }

    /** Whether files hold linear radiance instead of pixels. */
    public boolean isLinear() {
        return this != PNG;
    }

    /** Memory for rendering and writing the pictures, in bytes per pixel. */
    public long bytesPerPixel(List<StageOrView> pictures) {
        long drawn = pictures.stream()
                .mapToLong(picture -> BandedDrawing.bytesPerPixel(isLinear() || !picture.isColor()))
                .sum();
        return this == EXR ? 2 * drawn : drawn;
    }

    /** Whether 8-bit pixels are marked as sRGB; pictures of numbers always are, so that viewers show them unchanged. */
    static boolean isEncoded(RenderedView drawn, FrameInput input) {
        return input.srgb() || !drawn.picture().isColor();
    }

    /**
     * Writes a file, whole or not at all.
     *
     * @param drawn one picture; an EXR file can hold several
     * @param input the input of the rendered rows
     * @param alpha whether the pixels' alpha is written to a PNG
     * @param made stored in the file
     * @throws IOException as {@link dev.twister.files.WholeFile#write}
     */
    void write(Path file, List<RenderedView> drawn, FrameInput input, boolean alpha, Provenance made)
            throws IOException {
        RenderedView first = drawn.getFirst();
        int width = first.frame().width();
        int height = first.frame().height();
        switch (this) {
            case PNG -> PngWriter.write(file, width, height, first.pixels(), isEncoded(first, input), alpha, made);
            case HDR -> HdrWriter.write(file, width, height, first.frame().radiance(), made);
            case EXR -> {
                List<ExrChannel> channels = drawn.stream()
                        .flatMap(picture -> picture.channels(drawn.size() == 1).stream())
                        .toList();
                ExrWriter.write(
                        file,
                        new ExrPicture(
                                width, input.height(), input.firstRow(), input.rows(), channels, Optional.of(made)));
            }
        }
    }
}
