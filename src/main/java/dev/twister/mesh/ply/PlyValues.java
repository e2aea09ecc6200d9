package dev.twister.mesh.ply;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.TextCursor;
import dev.twister.mesh.ply.PlyHeader.PlyType;
import java.io.IOException;
import java.nio.ByteOrder;

/** Sequential access to the numbers after a PLY file's header. */
interface PlyValues {
    double next(PlyType type) throws IOException;

    /** Skips a number of values. */
    void skip(PlyType type, long count) throws IOException;

    /**
     * Ends an element. Text continues at the next line, because some programs write more numbers than the header
     * declares.
     */
    void endElement() throws IOException;

    /** An exception for a problem at the current position. */
    MeshException failure(String problem);

    /** Number of bytes left. */
    long remaining();

    /** Numbers as text, regardless of line breaks. */
    static PlyValues text(TextCursor text) {
        return new PlyValues() {
            @Override
            public double next(PlyType type) throws IOException {
                text.skipSpace();
                if (text.atEnd()) {
                    throw text.failure("truncated: the file ends before its last element; get or export it again");
                }
                return text.number();
            }

            @Override
            public void skip(PlyType type, long count) throws IOException {
                for (long i = 0; i < count; i++) {
                    next(type);
                }
            }

            @Override
            public void endElement() throws IOException {
                text.skipLine();
            }

            @Override
            public MeshException failure(String problem) {
                return text.failure(problem);
            }

            @Override
            public long remaining() {
                return text.remaining();
            }
        };
    }

    /** Binary numbers from a position on. */
    static PlyValues binary(Bytes bytes, long start, ByteOrder order) {
        return new PlyValues() {
            private long position = start;

            @Override
            public double next(PlyType type) throws IOException {
                long at = position;
                bytes.require(at, type.bytes(), "an element");
                position += type.bytes();
                return switch (type) {
                    case BYTE -> (byte) bytes.at(at);
                    case UNSIGNED_BYTE -> bytes.at(at);
                    case SHORT -> bytes.shortAt(at, order);
                    case UNSIGNED_SHORT -> Short.toUnsignedInt(bytes.shortAt(at, order));
                    case INT -> bytes.intAt(at, order);
                    case UNSIGNED_INT -> Integer.toUnsignedLong(bytes.intAt(at, order));
                    case FLOAT -> bytes.floatAt(at, order);
                    case DOUBLE -> bytes.doubleAt(at, order);
                };
            }

            @Override
            public void skip(PlyType type, long count) {
                bytes.require(position, count * type.bytes(), "a list");
                position += count * type.bytes();
            }

            @Override
            public void endElement() {}

            @Override
            public MeshException failure(String problem) {
                return bytes.failure(position, problem);
            }

            @Override
            public long remaining() {
                return bytes.length() - position;
            }
        };
    }
}
