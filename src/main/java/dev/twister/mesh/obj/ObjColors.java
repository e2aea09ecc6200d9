package dev.twister.mesh.obj;

import dev.twister.mesh.assembly.FloatList;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.TextCursor;
import dev.twister.scene.SrgbCurve;
import java.io.IOException;

/** Colors behind the coordinates of vertices in OBJ files: three numbers from 0 to 1, or to 255. */
final class ObjColors {
    private final FloatList colors = new FloatList();
    private double largest = 1;

    /**
     * Reads what is behind the coordinates of a vertex: nothing, a weight, or a color.
     *
     * @param vertices number of vertices so far, including this one
     */
    void read(TextCursor text, int vertices) throws IOException {
        if (text.atLineEnd()) {
            return;
        }
        double red = text.number();
        if (text.atLineEnd()) {
            return;
        }
        double green = text.number();
        double blue = text.atLineEnd() ? green : text.number();
        while (colors.size() < 3 * (vertices - 1)) {
            colors.add(Float.NaN);
        }
        for (double value : new double[] {red, green, blue}) {
            colors.add((float) value);
            largest = value > largest ? 255 : largest;
        }
    }

    /** Adds the colors of all vertices, if any has one; the others are white. */
    void addTo(TriangleSoup soup) {
        for (int vertex = 0; vertex < soup.vertices() && colors.size() > 0; vertex++) {
            boolean given = 3 * vertex < colors.size() && !Float.isNaN(colors.get(3 * vertex));
            if (given) {
                soup.color(linear(3 * vertex), linear(3 * vertex + 1), linear(3 * vertex + 2), 1);
            } else {
                soup.color(1, 1, 1, 1);
            }
        }
    }

    private double linear(int at) {
        return SrgbCurve.linear(colors.get(at) / largest);
    }
}
