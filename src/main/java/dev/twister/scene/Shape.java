package dev.twister.scene;

import java.util.Locale;

/**
 * Triangles without a file, about the origin.
 *
 * @param size the width along x, the height along y and the depth along z of the box that the shape fills, in meters
 */
public record Shape(Kind kind, Vector3 size) implements Geometry {
    /** What a shape is; each has a size that others are multiples of. */
    public enum Kind {
        BOX(1, 1),
        /** A rectangle that stands upright and faces -z. */
        QUAD(1, 0),
        /** Upright, with both ends closed. */
        CYLINDER(1, 1),
        /** Upright, with its tip at the top, and closed at the bottom. */
        CONE(1, 1),
        /** A ring that lies flat; its height is its tube's. */
        TORUS(0.25, 1),
        /** A ball of triangles. */
        ICOSPHERE(1, 1);

        @SuppressWarnings("ImmutableEnumChecker") // a record of numbers
        private final Vector3 unit;

        Kind(double height, double depth) {
            unit = new Vector3(1, height, depth);
        }

        /** The size of the shape of this kind that is one meter wide. */
        public Vector3 unit() {
            return unit;
        }
    }

    /** A shape of its kind's proportions. */
    public static Shape of(Kind kind, double width) {
        return new Shape(kind, kind.unit().times(width));
    }

    @Override
    public String name() {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    /** The shape, one meter wide, that {@link #stretch} makes this one; the same for many sizes. */
    public Shape basis() {
        return kind == Kind.TORUS
                ? new Shape(kind, new Vector3(1, size.y() / size.x(), 1))
                : new Shape(kind, kind.unit());
    }

    /** Factors along the axes. */
    public Vector3 stretch() {
        return new Vector3(size.x(), kind == Kind.TORUS ? size.x() : size.y(), kind == Kind.QUAD ? size.x() : size.z());
    }

    @Override
    public String toString() {
        return name();
    }
}
