package dev.twister.mesh.stl;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.assembly.PositionIndex;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextCursor;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Material;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** Reads STL files, binary and text. Their normals are ignored, because they follow from the corners. */
public final class StlReader {
    private static final int COUNT_AT = 80;
    private static final int TRIANGLES_AT = 84;
    private static final int TRIANGLE_BYTES = 50;
    private static final int NORMAL_BYTES = 12;

    /** Within this number of bytes, a text file that starts with "solid" has a facet or ends. */
    private static final int TEXT_START = 1024;

    private final Bytes bytes;
    private final double smoothDegrees;
    private final Warnings warnings;
    private final TriangleSoup soup;
    private final PositionIndex vertices;

    public StlReader(Bytes bytes, double smoothDegrees, Warnings warnings) {
        this.bytes = bytes;
        this.smoothDegrees = smoothDegrees;
        this.warnings = warnings;
        this.soup = new TriangleSoup(0, 0);
        this.vertices = new PositionIndex(soup.positions);
    }

    /** Whether the file's length matches its number of triangles. */
    public static boolean isBinary(Bytes bytes) throws IOException {
        return bytes.length() >= TRIANGLES_AT && bytes.length() == TRIANGLES_AT + TRIANGLE_BYTES * count(bytes);
    }

    private static long count(Bytes bytes) throws IOException {
        return Integer.toUnsignedLong(bytes.intAt(COUNT_AT, ByteOrder.LITTLE_ENDIAN));
    }

    public MeshFile read() throws IOException {
        String name = "";
        if (isBinary(bytes) || !isText()) {
            readBinary();
        } else {
            name = readText();
        }
        soup.warnOfUnusable(warnings);
        return MeshAssembly.assemble(soup, Axes.Z_UP, smoothDegrees).file(name, bytes, Material.DEFAULT);
    }

    private boolean isText() throws IOException {
        int count = (int) Math.min(TEXT_START, bytes.length());
        String start = new String(bytes.copy(0, count), StandardCharsets.ISO_8859_1).toLowerCase(Locale.ROOT);
        return start.stripLeading().startsWith("solid")
                && (bytes.length() < TRIANGLES_AT
                        || start.contains("facet")
                        || start.contains("endsolid")
                        || start.contains("end solid"));
    }

    private void readBinary() throws IOException {
        bytes.require(
                0,
                TRIANGLES_AT,
                "the header; STL has 84 bytes before its triangles, or is text that starts with 'solid'");
        long count = count(bytes);
        long held = (bytes.length() - TRIANGLES_AT) / TRIANGLE_BYTES;
        boolean wrongCount = count == 0 || count > held;
        if (wrongCount) {
            warnings.add("the header says " + count + " triangles, but the file holds " + held + ", which are read");
            count = held;
        }
        if (count > MeshLimits.TRIANGLES) {
            throw bytes.failure(MeshLimits.tooManyTriangles(count));
        }
        if (bytes.length() > TRIANGLES_AT + TRIANGLE_BYTES * count) {
            warnings.add("there are bytes after the last triangle; not read");
        }
        for (int triangle = 0; triangle < count; triangle++) {
            long at = TRIANGLES_AT + (long) TRIANGLE_BYTES * triangle + NORMAL_BYTES;
            int a = vertexAt(at, wrongCount);
            int b = vertexAt(at + 12, wrongCount);
            soup.triangle(a, b, vertexAt(at + 24, wrongCount));
        }
        StlColors.read(bytes, (int) count, soup);
    }

    /** @param doubtful whether the file may not be STL at all */
    private int vertexAt(long at, boolean doubtful) throws IOException {
        float x = bytes.floatAt(at, ByteOrder.LITTLE_ENDIAN);
        float y = bytes.floatAt(at + 4, ByteOrder.LITTLE_ENDIAN);
        float z = bytes.floatAt(at + 8, ByteOrder.LITTLE_ENDIAN);
        boolean usable = MeshLimits.areCoordinates(x, y, z);
        if (doubtful && !usable) {
            throw bytes.failure(
                    COUNT_AT,
                    "truncated, or not STL: the number of triangles does not match the length,"
                            + " and the coordinates at byte " + at + " are not numbers from -1e9 to 1e9");
        }
        return usable ? vertices.of(x, y, z) : missing();
    }

    private int missing() {
        soup.missingPosition();
        return soup.vertices() - 1;
    }

    private String readText() throws IOException {
        TextCursor text = new TextCursor(bytes);
        expect(text, "solid");
        String name = text.rest();
        for (String word = nextWord(text); !word.isEmpty(); word = nextWord(text)) {
            switch (word) {
                case "facet" -> readFacet(text);
                // A file may contain several solids.
                case "solid", "endsolid" -> text.skipLine();
                case "end" -> {
                    expect(text, "solid");
                    text.skipLine();
                    warnings.add("'end solid' is read as 'endsolid'");
                }
                default -> throw text.failure(QuotedText.text(word) + "; expected facet or endsolid");
            }
        }
        return name;
    }

    private void readFacet(TextCursor text) throws IOException {
        if (soup.triangles() == MeshLimits.TRIANGLES) {
            throw text.failure(MeshLimits.tooManyTriangles(soup.triangles() + 1L));
        }
        expect(text, "normal");
        text.skipLine();
        expect(text, "outer");
        expect(text, "loop");
        int a = readVertex(text);
        int b = readVertex(text);
        soup.triangle(a, b, readVertex(text));
        expect(text, "endloop");
        expect(text, "endfacet");
    }

    private int readVertex(TextCursor text) throws IOException {
        expect(text, "vertex");
        double[] position = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            position[axis] = text.number();
        }
        return MeshLimits.areCoordinates(position[0], position[1], position[2])
                ? vertices.of(position[0], position[1], position[2])
                : missing();
    }

    private static void expect(TextCursor text, String word) throws IOException {
        String found = nextWord(text);
        if (!found.equals(word)) {
            throw text.failure((found.isEmpty() ? "truncated: the file ends" : QuotedText.text(found)) + "; expected '"
                    + word + "'");
        }
    }

    private static String nextWord(TextCursor text) throws IOException {
        text.skipSpace();
        return text.word().toLowerCase(Locale.ROOT);
    }
}
