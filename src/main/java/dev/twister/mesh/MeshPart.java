package dev.twister.mesh;

import dev.twister.scene.Material;

/**
 * Triangles of one material at one place.
 *
 * @param name what the file calls it, may be empty
 * @param mesh which of the file's meshes, counted from 0; several parts may have the same
 * @param placement from the mesh's coordinates to the file's; it can be inverted, and may mirror
 * @param material what the file says that it is made of
 */
public record MeshPart(String name, int mesh, Affine placement, Material material) {}
