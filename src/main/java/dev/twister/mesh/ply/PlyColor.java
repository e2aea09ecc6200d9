package dev.twister.mesh.ply;

import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.ply.PlyHeader.Element;
import dev.twister.scene.SrgbCurve;
import java.util.Optional;

/**
 * The color in each row of an element of a PLY file.
 *
 * @param red number of the property in a row
 * @param largest what stands for 1
 */
record PlyColor(int red, int green, int blue, double largest) {
    /** Empty if the element has no color. */
    static Optional<PlyColor> of(Element element) {
        int red = element.indexOf("red", "diffuse_red", "r");
        int green = element.indexOf("green", "diffuse_green", "g");
        int blue = element.indexOf("blue", "diffuse_blue", "b");
        if (red < 0 || green < 0 || blue < 0) {
            return Optional.empty();
        }
        double largest = switch (element.properties().get(red).type()) {
            case BYTE, UNSIGNED_BYTE -> 255;
            case SHORT, UNSIGNED_SHORT -> 65_535;
            case INT, UNSIGNED_INT -> 255;
            case FLOAT, DOUBLE -> 1;
        };
        return Optional.of(new PlyColor(red, green, blue, largest));
    }

    void add(double[] row, TriangleSoup soup) {
        soup.color(linear(row[red]), linear(row[green]), linear(row[blue]), 1);
    }

    private double linear(double value) {
        return SrgbCurve.linear(value / largest);
    }
}
