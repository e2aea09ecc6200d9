package dev.twister.scene.format;

import static dev.twister.scene.format.Field.required;
import static dev.twister.scene.format.Field.sparse;

import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shape;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.SceneLimits;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The fields that say what a mesh's triangles are: those of a file, or of a shape. */
final class MeshFields {
    static final String SHAPE = "shape";
    static final String SIZE = "size";

    /** The size that a scene file leaves out. */
    static final Shape DEFAULT = Shape.of(Shape.Kind.BOX, 1);

    private MeshFields() {}

    static List<Field<Mesh, ?>> ofFile(ValueType.FilePath file) {
        return List.of(
                required("file", file, MeshFields::file, MeshFields::withFile).from(2),
                sparse(
                                "scene",
                                new ValueType.Text(0, SceneLimits.MAX_NAME_LENGTH),
                                MeshFields::scene,
                                MeshFields::withScene)
                        .from(3),
                sparse(
                                "animation",
                                new ValueType.Structure<>(
                                        MeshAnimation.NONE,
                                        Stream.concat(
                                                        Stream.of(required(
                                                                BodyProperties.ANIMATION_NAME.name(),
                                                                ValueType.of(
                                                                        BodyProperties.ANIMATION_NAME.type(),
                                                                        NamedFiles.UNRESOLVED),
                                                                MeshAnimation::name,
                                                                MeshAnimation::withName)),
                                                        Field.of(BodyProperties.ANIMATION, NamedFiles.UNRESOLVED)
                                                                .stream())
                                                .toList()),
                                Mesh::animation,
                                Mesh::withAnimation)
                        .from(4));
    }

    /** How the triangles of a file are shaded. */
    static List<Field<Mesh, ?>> shading() {
        return List.of(Field.of(BodyProperties.SMOOTH, NamedFiles.UNRESOLVED));
    }

    static List<Field<Mesh, ?>> ofShape() {
        return List.of(
                Field.<Mesh, Shape.Kind>required(
                                SHAPE,
                                new ValueType.Choice<>(Shape.Kind.class),
                                mesh -> shape(mesh).kind(),
                                (mesh, kind) -> mesh.withGeometry(ShapeSize.shape(kind, ShapeSize.of(shape(mesh)))))
                        .from(3),
                Field.<Mesh, List<Double>>sparse(
                                SIZE,
                                ShapeSize.TYPE,
                                mesh -> ShapeSize.of(shape(mesh)),
                                (mesh, size) -> mesh.withGeometry(
                                        ShapeSize.shape(shape(mesh).kind(), size)))
                        .from(3));
    }

    private static Path file(Mesh mesh) {
        return mesh.file()
                .orElseThrow(() ->
                        new SceneException("the triangles '" + mesh.geometry().name()
                                + "' were made in code and cannot be in a scene file; write them to a mesh file"));
    }

    private static Mesh withFile(Mesh mesh, Path path) {
        return mesh.withGeometry(new Geometry.OfFile(path, scene(mesh)));
    }

    private static String scene(Mesh mesh) {
        return mesh.geometry() instanceof Geometry.OfFile(Path _, String scene) ? scene : "";
    }

    private static Mesh withScene(Mesh mesh, String scene) {
        return mesh.withGeometry(new Geometry.OfFile(file(mesh), scene));
    }

    private static Shape shape(Mesh mesh) {
        if (mesh.geometry() instanceof Shape shape) {
            return shape;
        }
        throw new IllegalArgumentException("not a shape: " + mesh.geometry());
    }

    /** The size of a shape: its width, or a number for each axis. */
    private static final class ShapeSize {
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
}
