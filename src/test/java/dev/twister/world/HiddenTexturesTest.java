package dev.twister.world;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class HiddenTexturesTest {
    private static final Path FILE = Path.of("box.obj");
    private static final Material RED = Material.DEFAULT.withTexture(Path.of("skins", "red.png"));

    @Test
    void namesATextureOnAMeshWithoutTextureCoordinates() {
        Mesh own = Mesh.of(FILE).withMaterial(RED);

        assertThat(hidden(own, part(0, Material.DEFAULT), part(0, Material.DEFAULT)))
                .containsExactly("box.obj: no texture coordinates; the texture red.png is not shown");
    }

    @Test
    void namesATextureOfTheFilesOwn() {
        assertThat(hidden(Mesh.of(FILE), part(0, RED), part(1, RED), part(1, Material.DEFAULT)))
                .containsExactly(
                        "box.obj: no texture coordinates in 1 of 2 parts; the texture red.png is not shown" + " there");
    }

    @Test
    void isSilentWhereTexturesAreShownOrReplaced() {
        assertThat(hidden(Mesh.of(FILE), part(1, RED))).isEmpty();
        assertThat(hidden(Mesh.of(FILE).withMaterial(Material.DEFAULT), part(0, RED)))
                .isEmpty();
    }

    private static MeshPart part(int mesh, Material material) {
        return new MeshPart("", mesh, Affine.IDENTITY, material);
    }

    /** The first of the file's two meshes has no texture coordinates. */
    private static List<String> hidden(Mesh mesh, MeshPart... parts) {
        List<TriangleMesh> meshes = List.of(triangle(0), triangle(6));
        Scene scene = Scene.under(Path.of("sky.hdr")).withMeshes(List.of(mesh, mesh));
        return HiddenTextures.of(scene, SceneMeshes.of(scene, _ -> new MeshFile(meshes, List.of(parts), Map.of(), 0)));
    }

    private static TriangleMesh triangle(int coordinates) {
        return new TriangleMesh(
                new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new float[0], new float[coordinates], new int[] {0, 1, 2});
    }
}
