package dev.twister.cli.file;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Supplier;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * Reads the names of files. On Linux a name may have bytes that are no text, which Java replaces; they are kept.
 *
 * @param commandLine the bytes of this process's arguments, each ended by a zero; empty if they are not known
 */
public record PathConverter(Supplier<byte[]> commandLine) implements ITypeConverter<Path> {
    private static final Path ARGUMENTS = Path.of("/proc/self/cmdline");

    /** What Java has for bytes that are no text. */
    private static final String REPLACED = "\uFFFD";

    public PathConverter() {
        this(PathConverter::argumentsOfProcess);
    }

    private static byte[] argumentsOfProcess() {
        try {
            return Files.exists(ARGUMENTS) ? Files.readAllBytes(ARGUMENTS) : new byte[0];
        } catch (IOException _) {
            return new byte[0];
        }
    }

    @Override
    public Path convert(String text) {
        if (text.isEmpty()) {
            throw new TypeConversionException("the file name is empty");
        }
        try {
            return path(text);
        } catch (InvalidPathException problem) {
            throw new TypeConversionException("not a valid file name: " + problem.getMessage());
        }
    }

    /**
     * The path with this name.
     *
     * @throws InvalidPathException if it is none
     */
    public Path path(String text) {
        return text.contains(REPLACED) ? ofBytes(text) : Path.of(text);
    }

    private Path ofBytes(String text) {
        byte[] all = commandLine.get();
        int start = 0;
        for (int end = 0; end < all.length; end++) {
            if (all[end] == 0) {
                byte[] argument = Arrays.copyOfRange(all, start, end);
                String read = new String(argument, StandardCharsets.UTF_8);
                // The value of an option may stand behind its name.
                int name = read.endsWith("=" + text) ? read.length() - text.length() : 0;
                if (read.substring(name).equals(text)) {
                    int nameBytes = read.substring(0, name).getBytes(StandardCharsets.UTF_8).length;
                    return ofBytes(Arrays.copyOfRange(argument, nameBytes, argument.length));
                }
                start = end + 1;
            }
        }
        return Path.of(text);
    }

    /** Addresses hold any bytes. */
    private static Path ofBytes(byte[] name) {
        StringBuilder escaped = new StringBuilder();
        for (byte each : name) {
            escaped.append(each == '/' ? "/" : "%%%02X".formatted(each & 0xFF));
        }
        String folder = name[0] == '/'
                ? "file://"
                : Path.of("").toAbsolutePath().toUri().toString();
        return Path.of(URI.create((folder.endsWith("/") || name[0] == '/' ? folder : folder + "/") + escaped));
    }
}
