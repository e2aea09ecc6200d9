package dev.twister.world.table;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.kernel.Layout;
import dev.twister.mesh.TriangleMesh;
import org.junit.jupiter.api.Test;

class MeshGeometryTest {
    /** Two triangles, each ten times, with other first corners. */
    @Test
    void oneOfManyCopiesIsInALeaf() {
        float[] positions = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
        int[] corners = new int[60];
        for (int triangle = 0; triangle < 20; triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                int turned = (triangle / 2 + corner) % 3;
                corners[3 * triangle + corner] = triangle % 2 == 0 ? turned : (turned + 2) % 4;
            }
        }
        float[] none = {};

        MeshGeometry geometry = MeshGeometry.of(new TriangleMesh(positions, none, none, none, none, corners), false);

        assertThat(geometry.counts().nodes()).isOne();
        assertThat(geometry.floats()[Layout.NODE_SPHERES]).isEqualTo(2);
    }
}
