package dev.twister.cli;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the names of files. */
final class PathConverter implements ITypeConverter<Path> {
    @Override
    public Path convert(String text) {
        if (text.isEmpty()) {
            throw new TypeConversionException("a file's name cannot be empty");
        }
        try {
            return Path.of(text);
        } catch (InvalidPathException problem) {
            throw new TypeConversionException("this cannot be a file's name: " + problem.getMessage());
        }
    }
}
