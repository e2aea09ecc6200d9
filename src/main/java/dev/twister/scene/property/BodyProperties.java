package dev.twister.scene.property;

import static dev.twister.scene.property.Property.decimal;
import static dev.twister.scene.property.Property.flag;
import static dev.twister.scene.property.Property.vector;
import static dev.twister.scene.property.Slide.linear;
import static dev.twister.scene.property.Slide.logarithmic;

import dev.twister.scene.Ground;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.property.PropertyType.ClipName;
import dev.twister.scene.property.PropertyType.Turn;
import java.util.List;

/** The properties of spheres, meshes and the plane, but for those of their materials. */
public final class BodyProperties {
    public static final List<Property<Sphere, ?>> SPHERE = List.of(
            vector("position", SceneLimits.POSITION, Sphere::position, Sphere::withPosition)
                    .written()
                    .animated()
                    .means("the center")
                    .row("Sphere", "The position of the sphere's center.", "Alt+4 Alt+5 Alt+6")
                    .slide(Slide.PLACE),
            decimal("radius", SceneLimits.LENGTH, Sphere::radius, Sphere::withRadius)
                    .written()
                    .animated()
                    .means("its radius")
                    .row("Sphere radius", "The sphere's radius.", "Alt+7")
                    .slide(logarithmic(0.05, 10, 2, "m")));

    public static final List<Property<Mesh, ?>> MESH = List.of(
            vector("position", SceneLimits.POSITION, Mesh::position, Mesh::withPosition)
                    .since(2)
                    .animated()
                    .means("where the origin of the file or the center of the shape is")
                    .row("Mesh", "The position of the origin of the mesh's file.", "Alt+4 Alt+5 Alt+6")
                    .slide(Slide.PLACE),
            Property.of("rotation", new Turn(SceneLimits.ANGLE), Mesh::rotation, Mesh::withRotation)
                    .since(2)
                    .animated()
                    .means("yaw, pitch and roll")
                    .row(
                            "Mesh",
                            "How far the mesh is turned. It is rolled to its left side, then pitched forwards, then"
                                    + " turned to the right.",
                            "Alt+Shift+4 Alt+Shift+5 Alt+Shift+6")
                    .slide(Slide.ANGLE),
            decimal("scale", SceneLimits.FACTOR, Mesh::scale, Mesh::withScale)
                    .since(2)
                    .animated()
                    .means("meters per unit of the file; a factor of a shape's size")
                    .row(
                            "Mesh scale",
                            "Meters per unit of the mesh's file; of a shape, the factor of its size.",
                            "Alt+7")
                    .slide(logarithmic(0.001, 1000, 3, "")));

    /** Of the triangles of a file. */
    public static final Property<Mesh, Double> SMOOTH = decimal(
                    "smooth", new Range(0, 180, "degrees"), Mesh::smoothDegrees, Mesh::withSmoothDegrees)
            .since(2)
            .means("where a file has no normals: triangles that meet at no larger angle are shaded as one smooth"
                    + " surface; 0 leaves them flat")
            .row(
                    "Smooth",
                    "Where the file has no normals: triangles that meet at no larger angle are shaded as one smooth"
                            + " surface.",
                    "")
            .slide(linear(0, 180, 0, "°"));

    /** Which animation of the file a mesh plays; empty for none. */
    public static final Property<MeshAnimation, String> ANIMATION_NAME = Property.of(
                    "name", new ClipName(), MeshAnimation::name, MeshAnimation::withName)
            .since(4)
            .means("the animation's name in the file, or its number from 0")
            .row("Animation", "Which animation of its file the mesh plays in the film.", "");

    /** Of an animation of a file. */
    public static final List<Property<MeshAnimation, ?>> ANIMATION = List.of(
            decimal("start", SceneLimits.CLIP_TIME, MeshAnimation::start, MeshAnimation::withStart)
                    .since(4)
                    .animated()
                    .means("the animation's time at the beginning of the film")
                    .row("Animation start", "The animation's time at the beginning of the film.", "")
                    .slide(linear(0, 10, 2, "s")),
            decimal("speed", new Range(-1000, 1000), MeshAnimation::speed, MeshAnimation::withSpeed)
                    .since(4)
                    .means("seconds of the animation per second of the film; below 0 it plays backwards")
                    .row(
                            "Animation speed",
                            "Seconds of the animation per second of the film. Below 0 it plays backwards.",
                            "")
                    .slide(linear(-4, 4, 2, "")),
            flag("loop", MeshAnimation::loop, MeshAnimation::withLoop)
                    .since(4)
                    .means("whether it begins again where it ends; otherwise it stops there")
                    .row("Animation loop", "Begin the animation again where it ends. Off: it stops there.", ""));

    public static final List<Property<Ground, ?>> PLANE = List.of(
            decimal("size", SceneLimits.LENGTH, Ground::size, Ground::withSize)
                    .written()
                    .means("the side of the square")
                    .row("Plane size", "The side of the square. Walls stand on its border.", "Alt+Shift+P")
                    .slide(logarithmic(1, 1000, 1, "m")),
            decimal("height", SceneLimits.POSITION, Ground::height, Ground::withHeight)
                    .written()
                    .animated()
                    .means("its y")
                    .row("Plane height", "The plane's y. The camera stays above it.", "Alt+Shift+H")
                    .slide(Slide.PLACE));

    /** With a material by name; otherwise the second of the plane's colors. */
    public static final Property<Ground, Rgb> ODD_COLOR = Property.color(
                    "oddColor", SceneLimits.SHARE, Ground::oddColor, Ground::withOddColor)
            .since(2)
            .means("albedo where `floor(x) + floor(z)` is odd; the material's color where it is not given")
            .row("Second color", "The color of the other squares.", "Alt+Shift+C");

    private BodyProperties() {}
}
