package dev.twister.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads pixels such as {@code 640,360}. */
final class PixelConverter implements ITypeConverter<PixelConverter.Pixel> {
    /** Column and row, from 0 at the top left. */
    record Pixel(int column, int row) {}

    @Override
    public Pixel convert(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 2) {
            throw malformed(text);
        }
        try {
            return new Pixel(Integer.parseInt(parts[0].strip()), Integer.parseInt(parts[1].strip()));
        } catch (NumberFormatException _) {
            throw malformed(text);
        }
    }

    private static TypeConversionException malformed(String text) {
        return new TypeConversionException(
                "'" + text + "' is not a pixel; write column,row from 0,0 at the top left, such as 640,360");
    }
}
