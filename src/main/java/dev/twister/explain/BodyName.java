package dev.twister.explain;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What a scene file says of a body. A text is empty where the file has none.
 *
 * @param kind {@code light}, {@code plane}, {@code sphere}, {@code poured sphere} or {@code mesh}
 * @param number in the scene file's list, from 1
 * @param name of the body or light
 * @param material its name in {@code materials}
 * @param source the mesh's file as the scene names it, or its shape
 * @param part of a mesh's file that has several: its name, or such as {@code 2 of 3}
 */
public record BodyName(String kind, int number, String name, String material, String source, String part) {
    /** Such as {@code sphere 2, "Ball", material "glass"}. */
    String text() {
        return Stream.of(
                        kind.equals("plane") ? kind : kind + " " + number,
                        quoted("", name),
                        source,
                        part.isEmpty() ? "" : "part " + part,
                        quoted("material ", material))
                .filter(text -> !text.isEmpty())
                .collect(Collectors.joining(", "));
    }

    Map<String, Object> tree() {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("kind", kind);
        tree.put("number", number);
        Map<String, String> texts = new LinkedHashMap<>();
        texts.put("name", name);
        texts.put("material", material);
        texts.put("source", source);
        texts.put("part", part);
        texts.forEach((key, text) -> {
            if (!text.isEmpty()) {
                tree.put(key, text);
            }
        });
        return tree;
    }

    private static String quoted(String before, String name) {
        return name.isEmpty() ? "" : before + '"' + name + '"';
    }
}
