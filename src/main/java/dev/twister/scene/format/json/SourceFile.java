package dev.twister.scene.format.json;

import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.scene.SceneException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;

/** Reads a scene file's bytes as UTF-8, refusing what cannot be a scene before it costs memory. */
public final class SourceFile {
    /** The size that a scene file may have, in bytes: 64 MiB. */
    public static final int MAX_BYTES = 64 << 20;

    private static final String TOO_LARGE = "a scene file may have at most 67108864 bytes (64 MiB)";
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private SourceFile() {}

    /**
     * Reads a file whole.
     *
     * @throws SceneException if there is no such file, or it is no UTF-8 text of 1 to {@value #MAX_BYTES} bytes
     */
    public static SourceText read(Path file) {
        String name = file.toString();
        try {
            InputFile.problem(file).ifPresent(problem -> {
                throw failure(name, problem);
            });
            long size = Files.size(file);
            if (size > MAX_BYTES) {
                throw failure(name, "has " + size + " bytes; " + TOO_LARGE);
            }
            try (InputStream stream = Files.newInputStream(file)) {
                return decode(name, bytes(stream, name));
            }
        } catch (NoSuchFileException e) {
            throw failure(name, "file not found");
        } catch (IOException e) {
            throw failure(name, "cannot be read: " + Excerpt.sentence(SystemReason.of(e)));
        }
    }

    /**
     * Reads a stream to its end.
     *
     * @throws SceneException if it cannot be read, or is no UTF-8 text of 1 to {@value #MAX_BYTES} bytes
     */
    public static SourceText read(InputStream stream, String name) {
        try {
            return decode(name, bytes(stream, name));
        } catch (IOException e) {
            throw failure(name, "cannot be read: " + Excerpt.sentence(SystemReason.of(e)));
        }
    }

    public static SceneException failure(String file, String what) {
        return new SceneException(Excerpt.ofPath(file) + ": " + what);
    }

    private static byte[] bytes(InputStream stream, String name) throws IOException {
        // One byte more than allowed tells a file that has grown since its size was asked.
        byte[] bytes = stream.readNBytes(MAX_BYTES + 1);
        if (bytes.length > MAX_BYTES) {
            throw failure(name, "has more than " + MAX_BYTES + " bytes; " + TOO_LARGE);
        }
        if (bytes.length == 0) {
            throw failure(name, "the file is empty (0 bytes)");
        }
        return bytes;
    }

    private static SourceText decode(String name, byte[] bytes) {
        wideEncoding(bytes).ifPresent(encoding -> {
            throw failure(name, "is not UTF-8 text but " + encoding + "; save it as UTF-8");
        });
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
        ByteBuffer input = ByteBuffer.wrap(bytes);
        // UTF-8 never has more UTF-16 units than bytes.
        char[] characters = new char[bytes.length];
        CharBuffer output = CharBuffer.wrap(characters);
        CoderResult result = decoder.decode(input, output, true);
        SourceText text = new SourceText(name, characters, output.position());
        if (result.isError()) {
            int bad = bytes[input.position()] & 0xFF;
            throw text.failure(
                    output.position(), "is not UTF-8 text: the byte 0x%02X fits no character".formatted(bad));
        }
        if (characters[0] == BYTE_ORDER_MARK) {
            // White space instead of a mark: the parser accepts it, and it keeps every offset.
            characters[0] = ' ';
        }
        return text;
    }

    /** By its byte order mark, or where the zero bytes of its first character are (RFC 4627, 3). */
    private static Optional<String> wideEncoding(byte[] bytes) {
        int first = ByteBuffer.wrap(Arrays.copyOf(bytes, Integer.BYTES)).getInt();
        int high = first >>> 16;
        if (first == 0x0000feff || first == 0xfffe0000 || (bytes.length >= 4 && isOneOf(first, 0xff, 0xff000000))) {
            return Optional.of("UTF-32");
        }
        boolean marked = high == 0xfeff || high == 0xfffe;
        return marked || (bytes.length >= 2 && isOneOf(high, 0xff, 0xff00)) ? Optional.of("UTF-16") : Optional.empty();
    }

    /** Whether some bits of one of these bytes are set, and no others. */
    private static boolean isOneOf(int value, int low, int high) {
        return value != 0 && ((value & low) == value || (value & high) == value);
    }
}
