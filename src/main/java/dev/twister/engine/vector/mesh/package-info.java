/**
 * Meshes in lanes: a packet's rays go together through the hierarchy over the instances, and in each one's coordinates
 * through that over its triangles, as {@code MeshHit} and {@code MeshShadow} of the kernel do for one ray.
 */
package dev.twister.engine.vector.mesh;
