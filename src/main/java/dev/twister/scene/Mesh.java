package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import dev.twister.scene.select.Tag;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A body of triangles. It is scaled, then turned, then moved.
 *
 * @param position where the origin of the file or the center of the shape comes to be, in meters
 * @param rotation about that origin or center
 * @param scale meters per unit of the file, above 0; a factor of a shape's size
 * @param smoothDegrees where a file has no normals: triangles whose planes meet at no larger angle are shaded as one
 *     smooth surface, in [0, 180]; 0 leaves every triangle flat
 * @param animation of the file, which moves it in a film
 * @param material what it is made of, in place of what the file says
 */
@Copied
public record Mesh(
        Geometry geometry,
        Vector3 position,
        Rotation rotation,
        double scale,
        double smoothDegrees,
        MeshAnimation animation,
        Optional<Material> material,
        Tag tag)
        implements Body, MeshCopy.With {
    /** As its file has it; has the values of the fields that a scene file leaves out. */
    public static final Mesh DEFAULT = new Mesh(
            new Geometry.OfFile(Path.of("")),
            Vector3.ZERO,
            Rotation.NONE,
            1,
            0,
            MeshAnimation.NONE,
            Optional.empty(),
            Tag.NONE);

    public Mesh {
        requireNonNull(geometry, "geometry");
        requireNonNull(position, "position");
        requireNonNull(rotation, "rotation");
        requireNonNull(animation, "animation");
        requireNonNull(material, "material");
        requireNonNull(tag, "tag");
    }

    /** As the file has it, at the origin. */
    public static Mesh of(Path file) {
        return of(new Geometry.OfFile(file));
    }

    /** The triangles at the origin. */
    public static Mesh of(Geometry geometry) {
        return DEFAULT.withGeometry(geometry);
    }

    @Override
    public String kind() {
        return "mesh";
    }

    /** The file that it is read from; empty where there is none. */
    public Optional<Path> file() {
        return switch (geometry) {
            case Geometry.OfFile(Path path, String _) -> Optional.of(path);
            case Shape _, Triangles _ -> Optional.empty();
        };
    }

    /** The material that it has in place of the file's, or the default one to begin with. */
    public Material own() {
        return material.orElse(Material.DEFAULT);
    }

    @Override
    public Mesh withPosition(Vector3 newPosition) {
        return new Mesh(geometry, newPosition, rotation, scale, smoothDegrees, animation, material, tag);
    }

    public Mesh withMaterial(Material newMaterial) {
        return withMaterial(Optional.of(newMaterial));
    }

    /** Made of what its file says. */
    public Mesh withoutMaterial() {
        return withMaterial(Optional.empty());
    }

    @Override
    public Mesh withTag(Tag newTag) {
        return new Mesh(geometry, position, rotation, scale, smoothDegrees, animation, material, newTag);
    }
}
