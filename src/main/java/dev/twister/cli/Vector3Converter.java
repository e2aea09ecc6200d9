package dev.twister.cli;

import dev.twister.scene.Vector3;
import java.util.Arrays;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads places such as {@code 0,-5,-15}. */
final class Vector3Converter implements ITypeConverter<Vector3> {
    private static final int COORDINATES = 3;

    @Override
    public Vector3 convert(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != COORDINATES) {
            throw malformed(text);
        }
        try {
            double[] numbers =
                    Arrays.stream(parts).mapToDouble(Double::parseDouble).toArray();
            return new Vector3(numbers[0], numbers[1], numbers[2]);
        } catch (NumberFormatException _) {
            throw malformed(text);
        }
    }

    private static TypeConversionException malformed(String text) {
        return new TypeConversionException("'" + text + "' is not a position; write x,y,z in meters, such as 0,-5,-15");
    }
}
