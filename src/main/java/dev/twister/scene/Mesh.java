package dev.twister.scene;

import java.nio.file.Path;
import java.util.Optional;

/**
 * A body of triangles from a file. It is scaled, then rolled about z, pitched about x (positive looks down) and turned
 * about y (positive looks right), then moved.
 *
 * @param file OBJ, glTF, PLY or STL, already resolved against the scene file's folder
 * @param position where the file's origin comes to be, in meters
 * @param rotation in degrees: pitch as x, yaw as y, roll as z
 * @param scale meters per unit of the file, above 0
 * @param smoothDegrees where the file has no normals: triangles whose planes meet at no larger angle are shaded as one
 *     smooth surface, in [0, 180]; 0 leaves every triangle flat
 * @param material what it is made of, in place of what the file says
 */
public record Mesh(
        Path file, Vector3 position, Vector3 rotation, double scale, double smoothDegrees, Optional<Material> material)
        implements Body {
    /** As its file has it; has the values of the fields that a scene file leaves out. */
    public static final Mesh DEFAULT = new Mesh(Path.of(""), Vector3.ZERO, Vector3.ZERO, 1, 0, Optional.empty());

    /** As the file has it, at the origin. */
    public static Mesh of(Path file) {
        return DEFAULT.withFile(file);
    }

    @Override
    public String kind() {
        return "mesh";
    }

    /** The material that it has in place of the file's, or the default one to begin with. */
    public Material own() {
        return material.orElse(Material.DEFAULT);
    }

    public Mesh withFile(Path newFile) {
        return new Mesh(newFile, position, rotation, scale, smoothDegrees, material);
    }

    @Override
    public Mesh withPosition(Vector3 newPosition) {
        return new Mesh(file, newPosition, rotation, scale, smoothDegrees, material);
    }

    public Mesh withRotation(Vector3 newRotation) {
        return new Mesh(file, position, newRotation, scale, smoothDegrees, material);
    }

    public Mesh withScale(double newScale) {
        return new Mesh(file, position, rotation, newScale, smoothDegrees, material);
    }

    public Mesh withSmooth(double newDegrees) {
        return new Mesh(file, position, rotation, scale, newDegrees, material);
    }

    public Mesh withMaterial(Optional<Material> newMaterial) {
        return new Mesh(file, position, rotation, scale, smoothDegrees, newMaterial);
    }
}
