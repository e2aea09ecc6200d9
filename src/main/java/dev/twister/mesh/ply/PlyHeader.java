package dev.twister.mesh.ply;

import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextCursor;
import dev.twister.mesh.input.Warnings;
import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The header of a PLY file.
 *
 * @param order byte order of a binary file; empty for text
 * @param elements in the file's order
 * @param texture the texture file that a comment in MeshLab's style names
 */
record PlyHeader(Optional<ByteOrder> order, List<Element> elements, Optional<String> texture) {
    private static final int MAX_PROPERTIES = 1000;
    private static final int MAX_ELEMENTS = 100;

    /** A kind of element and the number of its instances. */
    record Element(String name, long count, List<Property> properties) {
        int indexOf(String... names) {
            for (String wanted : names) {
                for (int i = 0; i < properties.size(); i++) {
                    if (properties.get(i).name().equals(wanted)) {
                        return i;
                    }
                }
            }
            return -1;
        }

        /** Minimum size of an instance in bytes. */
        long leastBytes(boolean binary) {
            long least = 0;
            for (Property property : properties) {
                least += binary ? property.count().orElse(property.type()).bytes() : 2;
            }
            return least;
        }
    }

    /**
     * A number, or a list of numbers.
     *
     * @param count the type of a list's length; empty for a single number
     */
    record Property(String name, PlyType type, Optional<PlyType> count) {}

    /** Reads the header; leaves the cursor at the first element. */
    static PlyHeader read(TextCursor text, Warnings warnings) throws IOException {
        text.skipLine();
        Optional<ByteOrder> order = Optional.empty();
        Optional<String> texture = Optional.empty();
        boolean formatted = false;
        List<Element> elements = new ArrayList<>();
        while (true) {
            if (text.atEnd()) {
                throw text.failure("truncated: the file ends in the header; get or export it again");
            }
            String keyword = text.word();
            switch (keyword) {
                case "format" -> {
                    order = order(text);
                    formatted = true;
                }
                case "comment" -> {
                    if (text.word().equals("TextureFile")) {
                        texture = Optional.of(text.rest());
                    }
                }
                case "element" -> elements.add(element(text, elements.size()));
                case "property" -> property(text, elements);
                case "end_header" -> {
                    if (!formatted) {
                        throw text.failure("the header has no format");
                    }
                    text.skipLine();
                    return new PlyHeader(order, elements, texture);
                }
                case "obj_info", "" -> {}
                // Some programs write comments without their keyword.
                default -> warnings.add("header line " + QuotedText.text(keyword) + " is not read");
            }
            text.skipLine();
        }
    }

    private static Optional<ByteOrder> order(TextCursor text) throws IOException {
        String format = text.word();
        return switch (format) {
            case "ascii" -> Optional.empty();
            case "binary_little_endian" -> Optional.of(ByteOrder.LITTLE_ENDIAN);
            case "binary_big_endian" -> Optional.of(ByteOrder.BIG_ENDIAN);
            default ->
                throw text.failure("unknown format " + QuotedText.text(format)
                        + "; expected one of: ascii, binary_little_endian, binary_big_endian");
        };
    }

    private static Element element(TextCursor text, int earlier) throws IOException {
        if (earlier == MAX_ELEMENTS) {
            throw text.failure("more than " + MAX_ELEMENTS + " elements");
        }
        String name = text.word();
        long count = text.integer("how many of the element there are");
        if (count < 0) {
            throw text.failure(
                    "there are " + count + " of the element " + QuotedText.text(name) + "; expected 0 or more");
        }
        return new Element(name, count, new ArrayList<>());
    }

    private static void property(TextCursor text, List<Element> elements) throws IOException {
        if (elements.isEmpty()) {
            throw text.failure("a property before the first element");
        }
        List<Property> properties = elements.getLast().properties();
        if (properties.size() == MAX_PROPERTIES) {
            throw text.failure("more than " + MAX_PROPERTIES + " properties of an element");
        }
        String word = text.word();
        Optional<PlyType> count = word.equals("list") ? Optional.of(type(text, text.word())) : Optional.empty();
        PlyType type = type(text, count.isPresent() ? text.word() : word);
        properties.add(new Property(text.word(), type, count));
    }

    private static PlyType type(TextCursor text, String name) {
        return PlyType.of(name)
                .orElseThrow(() -> text.failure("unknown type " + QuotedText.text(name)
                        + "; expected one of: char, uchar, short, ushort, int, uint, float, double"));
    }

    /** The types of numbers in PLY files. */
    enum PlyType {
        BYTE(1, "char", "int8"),
        UNSIGNED_BYTE(1, "uchar", "uint8"),
        SHORT(2, "short", "int16"),
        UNSIGNED_SHORT(2, "ushort", "uint16"),
        INT(4, "int", "int32"),
        UNSIGNED_INT(4, "uint", "uint32"),
        FLOAT(4, "float", "float32"),
        DOUBLE(8, "double", "float64");

        private final int bytes;
        private final String name;
        private final String newerName;

        PlyType(int bytes, String name, String newerName) {
            this.bytes = bytes;
            this.name = name;
            this.newerName = newerName;
        }

        int bytes() {
            return bytes;
        }

        static Optional<PlyType> of(String name) {
            for (PlyType type : values()) {
                if (type.name.equals(name) || type.newerName.equals(name)) {
                    return Optional.of(type);
                }
            }
            return Optional.empty();
        }
    }
}
