package dev.twister.cli;

import dev.twister.bench.PictureSize;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads sizes such as 1280x720 and 4k. */
final class PictureSizeConverter implements ITypeConverter<PictureSize> {
    @Override
    public PictureSize convert(String text) {
        try {
            return PictureSize.parse(text);
        } catch (IllegalArgumentException problem) {
            throw new TypeConversionException(problem.getMessage());
        }
    }
}
