package dev.twister.scene;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.stream.Stream;

/**
 * A scene changed in one place, for every place that there is: each component of each record below the scene, found by
 * reflection.
 */
public final class SceneChanges {
    /** What a changed path begins with. */
    public static final String OTHER = "other-";

    private record Change<T>(String place, T value) {}

    private SceneChanges() {}

    /** The changed scenes by the place of the change, such as {@code camera.position.x}. */
    public static SequencedMap<String, Scene> of(Scene scene) {
        SequencedMap<String, Scene> changed = new LinkedHashMap<>();
        ofRecord(scene).forEach(change -> changed.put(change.place().substring(1), (Scene) change.value()));
        return changed;
    }

    /** The path that a changed scene has in place of a file. */
    public static Path other(Path file) {
        return file.resolveSibling(OTHER + file.getFileName());
    }

    private static Stream<Change<Object>> ofRecord(Record record) {
        RecordComponent[] components = record.getClass().getRecordComponents();
        Object[] values = Arrays.stream(components)
                .map(component -> value(record, component))
                .toArray();
        Stream<Change<Object>> changes = Stream.empty();
        for (int i = 0; i < components.length; i++) {
            int index = i;
            changes = Stream.concat(
                    changes,
                    of(values[index])
                            .map(change -> new Change<>(
                                    "." + components[index].getName() + change.place(),
                                    with(record, components, values, index, change.value()))));
        }
        return changes;
    }

    private static Stream<Change<Object>> of(Object value) {
        return switch (value) {
            case Double number -> leaf(number + 0.25);
            case Integer number -> leaf(number + 1);
            case Boolean flag -> leaf(!flag);
            case String text -> leaf(text + "x");
            case Path file -> leaf(other(file));
            case Enum<?> constant -> leaf(next(constant));
            case Record record -> ofRecord(record);
            // Maps that mesh files alone have.
            case Optional<?> none when none.isEmpty() -> Stream.empty();
            case Optional<?> some ->
                of(some.orElseThrow()).map(change -> new Change<>(change.place(), Optional.of(change.value())));
            // Views have no keyframes.
            case List<?> items when items.isEmpty() -> Stream.empty();
            case List<?> items ->
                of(items.getFirst())
                        .map(change -> new Change<>("[0]" + change.place(), replaced(items, change.value())));
            case Map<?, ?> named ->
                of(named.values().iterator().next())
                        .map(change -> new Change<>(
                                "[0]" + change.place(),
                                new LinkedHashMap<>(
                                        Map.of(named.keySet().iterator().next(), change.value()))));
            default -> throw new IllegalArgumentException("a scene has a " + value.getClass());
        };
    }

    private static Stream<Change<Object>> leaf(Object value) {
        return Stream.of(new Change<>("", value));
    }

    private static Object next(Enum<?> constant) {
        Object[] all = constant.getDeclaringClass().getEnumConstants();
        return all[(List.of(all).indexOf(constant) + 1) % all.length];
    }

    private static List<Object> replaced(List<?> items, Object first) {
        List<Object> replaced = new ArrayList<>(items);
        replaced.set(0, first);
        return replaced;
    }

    private static Object with(Record record, RecordComponent[] components, Object[] values, int index, Object value) {
        Object[] changed = values.clone();
        changed[index] = value;
        Class<?>[] types =
                Arrays.stream(components).map(RecordComponent::getType).toArray(Class[]::new);
        try {
            Constructor<?> constructor = record.getClass().getDeclaredConstructor(types);
            return constructor.newInstance(changed);
        } catch (ReflectiveOperationException problem) {
            throw new IllegalStateException(problem);
        }
    }

    private static Object value(Record record, RecordComponent component) {
        try {
            return component.getAccessor().invoke(record);
        } catch (IllegalAccessException | InvocationTargetException problem) {
            throw new IllegalStateException(problem);
        }
    }
}
