package dev.twister.mesh;

import dev.twister.scene.Material;

/**
 * Triangles of one material and placement.
 *
 * @param name the file's name for it, may be empty
 * @param mesh index of one of the file's meshes, from 0; several parts may share one
 * @param placement transform from the mesh's coordinates to the file's; invertible, possibly mirroring
 * @param material the file's material
 */
public record MeshPart(String name, int mesh, Affine placement, Material material) {}
