package dev.twister.scene.format;

import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import java.util.List;

/** The size of a shape: its width, or a number for each axis. */
final class ShapeSize {
    static final NumberOrVector TYPE = new NumberOrVector(
            new ValueType.Decimal(SceneLimits.LENGTH),
            new ValueType.Array<>(
                    new ValueType.Decimal(SceneLimits.SHAPE_SIDE),
                    3,
                    3,
                    "a number or an array of 3 numbers [x, y, z]"));

    private ShapeSize() {}

    /** The numbers for a shape. */
    static List<Double> of(Shape shape) {
        Vector3 size = shape.size();
        return size.equals(shape.kind().unit().times(size.x()))
                ? List.of(size.x())
                : List.of(size.x(), size.y(), size.z());
    }

    /** The shape of that kind whose size the numbers are. */
    static Shape shape(Shape.Kind kind, List<Double> size) {
        return size.size() == 1
                ? Shape.of(kind, size.getFirst())
                : new Shape(kind, new Vector3(size.get(0), size.get(1), size.get(2)));
    }
}
