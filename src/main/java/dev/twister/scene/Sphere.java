package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import dev.twister.scene.select.Tag;

/**
 * A sphere.
 *
 * @param position its center, in meters
 * @param radius in meters, above 0
 */
@Copied
public record Sphere(Vector3 position, double radius, Material material, Tag tag) implements Body, SphereCopy.With {
    /** A matte white ball of radius 1 at the origin; has the values of the fields that {@link #of} leaves out. */
    public static final Sphere DEFAULT = new Sphere(Vector3.ZERO, 1, Material.DEFAULT, Tag.NONE);

    public Sphere {
        requireNonNull(position, "position");
        requireNonNull(material, "material");
        requireNonNull(tag, "tag");
    }

    /** A smooth, opaque sphere; color and reflectivity are {@link Material}'s. */
    public static Sphere of(Vector3 position, double radius, Rgb color, double reflectivity) {
        return of(position, radius, Material.DEFAULT.withColor(color).withReflectivity(reflectivity));
    }

    public static Sphere of(Vector3 position, double radius, Material material) {
        return DEFAULT.withPosition(position).withRadius(radius).withMaterial(material);
    }

    @Override
    public String kind() {
        return "sphere";
    }

    public Rgb color() {
        return material.color();
    }

    public double reflectivity() {
        return material.reflectivity();
    }

    @Override
    public Sphere withPosition(Vector3 newPosition) {
        return new Sphere(newPosition, radius, material, tag);
    }

    @Override
    public Sphere withTag(Tag newTag) {
        return new Sphere(position, radius, material, newTag);
    }

    public Sphere withColor(Rgb newColor) {
        return withMaterial(material.withColor(newColor));
    }

    public Sphere withReflectivity(double newReflectivity) {
        return withMaterial(material.withReflectivity(newReflectivity));
    }
}
