package dev.twister.scene.format;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A schema in which larger parts that occur more than once stand once, under {@code $defs}. */
final class SchemaDefinitions {
    private static final int LEAST_LENGTH = 150;

    private final Map<Object, Integer> counts = new HashMap<>();
    private final Map<Object, String> names = new LinkedHashMap<>();
    private final Map<String, Object> definitions = new LinkedHashMap<>();

    private SchemaDefinitions() {}

    static Map<String, Object> of(Map<String, Object> schema) {
        SchemaDefinitions definitions = new SchemaDefinitions();
        definitions.count(schema);
        Map<String, Object> shortened = new LinkedHashMap<>();
        schema.forEach((key, value) -> shortened.put(key, definitions.shortened(value, key)));
        shortened.put("$defs", definitions.definitions);
        return shortened;
    }

    private void count(Object node) {
        switch (node) {
            case Map<?, ?> map -> {
                // Parts of what is known need no second look.
                if (counts.merge(map, 1, Integer::sum) == 1) {
                    map.values().forEach(this::count);
                }
            }
            case List<?> list -> list.forEach(this::count);
            default -> {}
        }
    }

    private Object shortened(Object node, String name) {
        return switch (node) {
            case Map<?, ?> map
            when isShared(map) -> {
                String known = names.get(map);
                if (known == null) {
                    known = free(name);
                    names.put(map, known);
                    definitions.put(known, Map.of());
                    definitions.put(known, parts(map, name));
                }
                yield Map.of("$ref", "#/$defs/" + known);
            }
            case Map<?, ?> map -> parts(map, name);
            case List<?> list ->
                list.stream().map(item -> shortened(item, name)).toList();
            default -> node;
        };
    }

    private boolean isShared(Map<?, ?> map) {
        return (map.containsKey("type") || map.containsKey("if"))
                && counts.getOrDefault(map, 0) > 1
                && map.toString().length() > LEAST_LENGTH;
    }

    private Map<String, Object> parts(Map<?, ?> map, String name) {
        Map<String, Object> parts = new LinkedHashMap<>();
        map.forEach((key, value) -> parts.put(
                (String) key,
                shortened(value, List.of("items", "then", "else", "properties").contains(key) ? name : (String) key)));
        return parts;
    }

    private String free(String name) {
        String free = name;
        for (int number = 2; definitions.containsKey(free); number++) {
            free = name + number;
        }
        return free;
    }
}
