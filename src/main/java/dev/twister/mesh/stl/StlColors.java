package dev.twister.mesh.stl;

import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.Bytes;
import dev.twister.scene.SrgbCurve;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Colors in binary STL, which are in the two bytes behind each triangle: red, green and blue of five bits, and a flag.
 * VisCAM sets the flag where there is a color, from blue in the lowest bits on. Materialise names the color of the
 * whole in the header, sets the flag where a triangle has that, and begins with red.
 */
final class StlColors {
    private static final int HEADER_BYTES = 80;
    private static final int TRIANGLE_BYTES = 50;
    private static final int FIRST_AT = 84 + 48;
    private static final int FLAG = 0x8000;
    private static final String WHOLE = "COLOR=";

    private StlColors() {}

    /** Adds the triangles' colors, if there are any. */
    static void read(Bytes bytes, int triangles, TriangleSoup soup) throws IOException {
        String header = new String(bytes.copy(0, HEADER_BYTES), StandardCharsets.ISO_8859_1);
        int whole = header.indexOf(WHOLE);
        if (whole >= 0 && whole + WHOLE.length() + 3 <= HEADER_BYTES) {
            ofMaterialise(bytes, triangles, header, whole + WHOLE.length(), soup);
        } else {
            ofViscam(bytes, triangles, soup);
        }
    }

    private static void ofMaterialise(Bytes bytes, int triangles, String header, int at, TriangleSoup soup)
            throws IOException {
        for (int triangle = 0; triangle < triangles; triangle++) {
            int bits = bits(bytes, triangle);
            if ((bits & FLAG) != 0) {
                soup.color(
                        SrgbCurve.linear(header.charAt(at) / 255.0),
                        SrgbCurve.linear(header.charAt(at + 1) / 255.0),
                        SrgbCurve.linear(header.charAt(at + 2) / 255.0),
                        1);
            } else {
                soup.color(linear(bits), linear(bits >> 5), linear(bits >> 10), 1);
            }
            paint(soup);
        }
    }

    private static void ofViscam(Bytes bytes, int triangles, TriangleSoup soup) throws IOException {
        boolean any = false;
        for (int triangle = 0; triangle < triangles && !any; triangle++) {
            any = (bits(bytes, triangle) & FLAG) != 0;
        }
        for (int triangle = 0; triangle < triangles && any; triangle++) {
            int bits = bits(bytes, triangle);
            if ((bits & FLAG) != 0) {
                soup.color(linear(bits >> 10), linear(bits >> 5), linear(bits), 1);
            } else {
                soup.color(1, 1, 1, 1);
            }
            paint(soup);
        }
    }

    /** Gives the next triangle's corners the last color. */
    private static void paint(TriangleSoup soup) {
        for (int corner = 0; corner < 3; corner++) {
            soup.colorOf.add(soup.colors.size() / 4 - 1);
        }
    }

    private static int bits(Bytes bytes, int triangle) throws IOException {
        return Short.toUnsignedInt(bytes.shortAt(FIRST_AT + (long) TRIANGLE_BYTES * triangle, ByteOrder.LITTLE_ENDIAN));
    }

    private static double linear(int bits) {
        return SrgbCurve.linear((bits & 31) / 31.0);
    }
}
