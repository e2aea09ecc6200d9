package dev.twister.cli.option;

import dev.twister.image.PictureSize;
import dev.twister.scene.Rendering;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads sizes such as 1280x720 and 4k. */
public final class PictureSizeConverter implements ITypeConverter<PictureSize> {
    @Override
    public PictureSize convert(String text) {
        PictureSize size;
        try {
            size = PictureSize.parse(text);
        } catch (IllegalArgumentException problem) {
            throw new TypeConversionException(problem.getMessage());
        }
        if (Math.max(size.width(), size.height()) > Rendering.MAX_SIDE) {
            throw new TypeConversionException(
                    "the size " + size + " is not from 1x1 to " + Rendering.MAX_SIDE + "x" + Rendering.MAX_SIDE);
        }
        return size;
    }
}
