package dev.twister.mesh.obj;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.assembly.FloatList;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.TextureLayout;
import java.util.ArrayList;
import java.util.List;

/** The places of textures in an OBJ file's material libraries, which become sets of texture coordinates. */
final class MtlLayouts {
    private static final int MOST = 16;

    private final List<TextureLayout> layouts = new ArrayList<>(List.of(TextureLayout.PLAIN));

    /**
     * The number of the texture coordinates for the options {@code -s} and {@code -o}, whose v runs upward.
     *
     * @throws MeshException if there are too many
     */
    int number(double scaleU, double scaleV, double offsetU, double offsetV) {
        boolean plain = scaleU == 1 && scaleV == 1 && offsetU == 0 && offsetV == 0;
        TextureLayout layout =
                plain ? TextureLayout.PLAIN : new TextureLayout(scaleU, scaleV, 1, 0, offsetU, 1 - scaleV - offsetV);
        if (!layouts.contains(layout)) {
            if (layouts.size() == MOST) {
                throw new MeshException("more than " + MOST + " different scales and offsets of textures");
            }
            layouts.add(layout);
        }
        return layouts.indexOf(layout);
    }

    /** Adds the texture coordinates of all layouts but the first, which are the file's own. */
    void addTo(TriangleSoup soup) {
        FloatList own = soup.textureCoordinates;
        for (int number = 1; number < layouts.size(); number++) {
            TextureLayout layout = layouts.get(number);
            for (int at = 0; at < own.size(); at += 2) {
                double u = own.get(at);
                double v = own.get(at + 1);
                soup.furtherCoordinates(number, layout.u(u, v), layout.v(u, v));
            }
        }
    }
}
