/** Triangle meshes, and the readers of OBJ, glTF, PLY and STL files. */
package dev.twister.mesh;
