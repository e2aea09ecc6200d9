package dev.twister.world;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Textures of meshes that no picture shows, because the mesh files have no texture coordinates. */
public final class HiddenTextures {
    private HiddenTextures() {}

    /** One line for each mesh file and texture, which names both. */
    public static List<String> of(Scene scene, SceneMeshes meshes) {
        Set<String> lines = new LinkedHashSet<>();
        for (Mesh mesh : scene.meshes()) {
            hidden(mesh, meshes.file(mesh)).forEach((texture, parts) -> lines.add(line(mesh, texture, parts)));
        }
        return List.copyOf(lines);
    }

    private record Parts(int without, int all) {
        Parts with(boolean hasCoordinates) {
            return new Parts(without + (hasCoordinates ? 0 : 1), all + 1);
        }
    }

    private static Map<Path, Parts> hidden(Mesh mesh, MeshFile file) {
        Map<Path, Parts> byTexture = new LinkedHashMap<>();
        Optional<Material> own = mesh.material();
        for (MeshPart part : file.parts()) {
            boolean hasCoordinates = file.meshes().get(part.mesh()).textureCoordinates().length > 0;
            own.orElse(part.material())
                    .images()
                    .forEach(texture -> byTexture.compute(
                            texture, (_, parts) -> (parts == null ? new Parts(0, 0) : parts).with(hasCoordinates)));
        }
        byTexture.values().removeIf(parts -> parts.without() == 0);
        return byTexture;
    }

    private static String line(Mesh mesh, Path texture, Parts parts) {
        String where = parts.without() == parts.all() ? "" : " in " + parts.without() + " of " + parts.all() + " parts";
        return mesh.geometry() + ": no texture coordinates" + where + "; the texture " + texture.getFileName()
                + " is not shown" + (where.isEmpty() ? "" : " there");
    }
}
