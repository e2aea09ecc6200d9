package dev.twister.gui.edit;

import dev.twister.scene.Light;
import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;
import dev.twister.scene.select.Tag;
import dev.twister.scene.select.VisibleBodies;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Edits of the names and groups of bodies, and of whether they are hidden or locked, by their {@link BodyNumber}. */
public final class TagEdits {
    private TagEdits() {}

    /** The tag of a body; none if it has no place for one. */
    public static Tag of(Scene scene, int body) {
        if (BodyEdits.isLight(scene, body)) {
            return BodyEdits.light(scene, body).tag();
        }
        return BodyEdits.isSolid(scene, body) ? BodyEdits.solid(scene, body).tag() : Tag.NONE;
    }

    /** The scene with other tags of those bodies. */
    public static Scene edited(Scene scene, Collection<Integer> bodies, UnaryOperator<Tag> change) {
        Scene edited = BodyEdits.edited(
                scene,
                Set.copyOf(bodies),
                (_, sphere) -> sphere.withTag(change.apply(sphere.tag())),
                (_, mesh) -> mesh.withTag(change.apply(mesh.tag())));
        if (bodies.stream().noneMatch(body -> BodyEdits.isLight(scene, body))) {
            return edited;
        }
        List<Light> lights = new ArrayList<>(scene.lights().list());
        for (int body : bodies) {
            if (BodyEdits.isLight(scene, body)) {
                Light light = BodyEdits.light(scene, body);
                lights.set(BodyNumber.light(body), light.withTag(change.apply(light.tag())));
            }
        }
        return edited.withLights(new Lights(lights));
    }

    /** Those of the bodies that can be hidden: not the last visible light. */
    public static List<Integer> hideable(Scene scene, Collection<Integer> bodies) {
        boolean lightStays = IntStream.range(0, scene.lights().count())
                .anyMatch(index ->
                        !scene.lights().get(index).tag().hidden() && !bodies.contains(BodyNumber.ofLight(index)));
        return bodies.stream()
                .filter(body -> BodyEdits.isSolid(scene, body) || (lightStays && BodyEdits.isLight(scene, body)))
                .toList();
    }

    /** The bodies that have some property of their tag. */
    public static List<Integer> having(Scene scene, Predicate<Tag> property) {
        return Stream.of(
                        IntStream.range(0, scene.lights().count())
                                .filter(index ->
                                        property.test(scene.lights().get(index).tag()))
                                .map(BodyNumber::ofLight),
                        IntStream.range(0, scene.spheres().size())
                                .filter(index ->
                                        property.test(scene.spheres().get(index).tag()))
                                .map(BodyNumber::ofSphere),
                        IntStream.range(0, scene.meshes().size())
                                .filter(index ->
                                        property.test(scene.meshes().get(index).tag()))
                                .map(BodyNumber::ofMesh))
                .flatMapToInt(numbers -> numbers)
                .boxed()
                .toList();
    }

    /** The bodies of a group. */
    public static List<Integer> members(Scene scene, String group) {
        return having(scene, tag -> tag.group().equals(group));
    }

    /** A name that no group of the scene has yet. */
    public static String newGroup(Scene scene) {
        Set<String> taken =
                VisibleBodies.tags(scene).map(Tag::group).collect(Collectors.toCollection(LinkedHashSet::new));
        return IntStream.iterate(1, number -> number + 1)
                .mapToObj(number -> "Group " + number)
                .filter(name -> !taken.contains(name))
                .findFirst()
                .orElseThrow();
    }

    /** Whether two scenes have bodies with the same tags. */
    @SuppressWarnings("ReferenceEquality") // to compare all spheres takes longer
    public static boolean areSame(Scene one, Scene other) {
        return (one.bodies() == other.bodies() && one.lights() == other.lights())
                || VisibleBodies.tags(one)
                        .toList()
                        .equals(VisibleBodies.tags(other).toList());
    }

    /** Whether other bodies are hidden in one scene than in the other, which has as many. */
    @SuppressWarnings("ReferenceEquality") // to compare all spheres takes longer
    public static boolean hideOthers(Scene one, Scene other) {
        return (one.bodies() != other.bodies() || one.lights() != other.lights())
                && !having(one, Tag::hidden).equals(having(other, Tag::hidden));
    }
}
