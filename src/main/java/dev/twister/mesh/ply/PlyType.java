package dev.twister.mesh.ply;

import java.util.Optional;

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
