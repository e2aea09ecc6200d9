/**
 * Meshes in lanes. A packet's rays together traverse the hierarchy over instances and then, in mesh coordinates, the
 * hierarchy over an instance's triangles. The kernel's {@code MeshHit} and {@code MeshShadow} do this for a single ray.
 */
package dev.twister.engine.vector.mesh;
