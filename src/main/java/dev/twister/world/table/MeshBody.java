package dev.twister.world.table;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshPlacement;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.util.ArrayList;
import java.util.List;

/**
 * A part of a mesh file in the scene; each is one body.
 *
 * @param placement transform from the mesh's coordinates to the world's
 * @param vertexColors whether the file's vertex colors multiply its material's
 */
public record MeshBody(Affine placement, Material material, boolean vertexColors, MeshPlace place) {
    /** All mesh bodies of a scene, in the order of its meshes and their files' parts. */
    public static List<MeshBody> of(Scene scene, SceneMeshes meshes, Vector3 origin) {
        List<MeshBody> bodies = new ArrayList<>();
        for (Mesh mesh : scene.meshes()) {
            Affine placement =
                    MeshPlacement.of(mesh.withPosition(mesh.position().minus(origin)));
            for (MeshPart part : meshes.file(mesh).parts()) {
                MeshPlace place = meshes.place(mesh, part.mesh());
                Material material = mesh.material().orElse(part.material());
                bodies.add(new MeshBody(
                        placement.of(part.placement()),
                        place.counts().texturePlaces() > 0 ? material : material.withoutImages(),
                        mesh.material().isEmpty() && place.counts().colors() > 0,
                        place));
            }
        }
        return bodies;
    }
}
