package dev.twister.cli.option;

import java.util.OptionalDouble;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads an exposure, such as {@code 1.5} or {@code auto}. */
final class ExposureConverter implements ITypeConverter<ExposureConverter.Exposure> {
    static final String AUTO = "auto";

    /**
     * What was asked for.
     *
     * @param stops empty where the picture is to tell
     */
    record Exposure(OptionalDouble stops) {}

    @Override
    public Exposure convert(String text) {
        if (text.equalsIgnoreCase(AUTO)) {
            return new Exposure(OptionalDouble.empty());
        }
        try {
            return new Exposure(OptionalDouble.of(Double.parseDouble(text)));
        } catch (NumberFormatException _) {
            throw new TypeConversionException("'" + text + "' is not an exposure; write stops, such as 1.5, or auto");
        }
    }
}
