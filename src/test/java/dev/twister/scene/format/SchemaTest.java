package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.property.Range;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.json.JsonMapper;

/** The schema for editors has the same fields, ranges and defaults as the reader. */
class SchemaTest {
    private static final JsonMapper JSON = JsonMapper.shared();
    private static final String DEFINITION = "#/$defs/";
    private static final String NO_CONTROL_CHARACTERS = "^[^\\u0000-\\u001f\\u007f-\\u009f]*$";

    private static final String TARGETS =
            "^(camera|plane|sky|shading|rendering|(lights|spheres|meshes)\\[(0|[1-9][0-9]{0,6})\\])$";

    @Test
    @SuppressWarnings("unchecked") // a JSON object
    void schemaSaysWhatTheReaderTakes() throws Exception {
        Map<String, Object> schema =
                JSON.readValue(Files.readString(Path.of("scenes", "scene.schema.json")), Map.class);
        Map<String, Object> definitions = (Map<String, Object>) schema.remove("$defs");
        schema.keySet().removeAll(List.of("$schema", "title"));

        assertThat(resolved(schema, definitions)).isEqualTo(schemaOfScenes());
    }

    /** Fields of the newest version that older versions lack. */
    private static Map<String, Object> schemaOfScenes() {
        Map<String, Object> schema = schemaOf(format(Scene.VERSION).scene());
        List<Map<String, Object>> older = new ArrayList<>();
        for (int version = 1; version < Scene.VERSION; version++) {
            older.add(schema(Map.of(
                    "if",
                    Map.of("properties", Map.of("version", Map.of("const", (double) version))),
                    "then",
                    refusalOfNewer(format(version).scene()).orElseThrow())));
        }
        schema.put("allOf", older);
        return schema;
    }

    private static SceneFormat format(int version) {
        return new SceneFormat(version, new LinkedHashMap<>(), NamedFiles.UNRESOLVED);
    }

    /** A schema that rejects fields of later versions, if there are any. */
    private static Optional<Map<String, Object>> refusalOfNewer(ValueType<?> type) {
        return switch (type) {
            case ValueType.Array<?> array -> refusalOfNewer(array.item()).map(items -> schema(Map.of("items", items)));
            case ValueType.Lines<?>(ValueType.Array<?> array) -> refusalOfNewer(array);
            case ValueType.Converted<?, ?> converted -> refusalOfNewer(converted.stored());
            case ValueType.Structure<?> structure -> newerIn(structure);
            case Shaped<?> shaped -> newerIn(shaped);
            default -> Optional.empty();
        };
    }

    private static <R> Optional<Map<String, Object>> newerIn(ValueType.Structure<R> structure) {
        return refused(structure.fields(), structure.newer());
    }

    private static <R> Optional<Map<String, Object>> newerIn(Shaped<R> shaped) {
        return refused(fields(shaped), newer(shaped));
    }

    private static <R> List<Field<R, ?>> fields(ObjectType<R> type) {
        return switch (type) {
            case Shaped<R> shaped -> fields(shaped.plain());
            case ValueType.Structure<R> structure -> structure.fields();
        };
    }

    private static <R> List<Field<R, ?>> newer(ObjectType<R> type) {
        return switch (type) {
            case Shaped<R> shaped ->
                Stream.concat(newer(shaped.keyed()).stream(), newer(shaped.plain()).stream())
                        .toList();
            case ValueType.Structure<R> structure -> structure.newer();
        };
    }

    private static <R> Optional<Map<String, Object>> refused(List<Field<R, ?>> fields, List<Field<R, ?>> newer) {
        Map<String, Object> properties = new TreeMap<>();
        newer.forEach(field -> properties.put(field.name(), false));
        fields.forEach(
                field -> refusalOfNewer(field.type()).ifPresent(refusal -> properties.put(field.name(), refusal)));
        return Optional.of(properties).filter(all -> !all.isEmpty()).map(all -> schema(Map.of("properties", all)));
    }

    /** The schema without descriptions and references, with numbers as doubles. */
    private static Object resolved(Object node, Map<String, Object> definitions) {
        return switch (node) {
            case Map<?, ?> map
            when map.get("$ref") instanceof String reference ->
                resolved(definitions.get(reference.substring(DEFINITION.length())), definitions);
            case Map<?, ?> map -> {
                Map<String, Object> fields = new TreeMap<>();
                map.forEach((name, value) -> {
                    if (!("description".equals(name) && value instanceof String)) {
                        fields.put((String) name, resolved(value, definitions));
                    }
                });
                yield fields;
            }
            case List<?> list ->
                list.stream().map(item -> resolved(item, definitions)).toList();
            case Number number -> number.doubleValue();
            default -> node;
        };
    }

    private static Map<String, Object> schemaOf(ValueType<?> type) {
        return switch (type) {
            case ValueType.Decimal(Range range) -> numbers("number", range);
            case ValueType.WholeNumber(Range range) -> numbers("integer", range);
            case ValueType.Flag() -> schema(Map.of("type", "boolean"));
            case ValueType.Text(int min, int max) ->
                withLeast(
                        "minLength",
                        min,
                        schema(Map.of("type", "string", "maxLength", (double) max, "pattern", NO_CONTROL_CHARACTERS)));
            case ValueType.GroupName() -> schema(Map.of("type", "string", "pattern", "^[A-Za-z0-9_-]{0,20}$"));
            case ValueType.FilePath(ValueType.Text text, NamedFiles _) -> schemaOf(text);
            case ValueType.Version(int newest) ->
                schema(Map.of(
                        "enum",
                        IntStream.rangeClosed(1, newest)
                                .asDoubleStream()
                                .boxed()
                                .toList()));
            case ValueType.Choice<?> choice -> schema(Map.of("enum", choice.names()));
            case ValueType.Array<?> array ->
                withLeast(
                        "minItems",
                        array.minItems(),
                        schema(Map.of("type", "array", "items", schemaOf(array.item()), "maxItems", (double)
                                array.maxItems())));
            case ValueType.Lines<?>(ValueType.Array<?> array) -> schemaOf(array);
            case ValueType.Converted<?, ?> converted -> schemaOf(converted.stored());
            case ValueType.Structure<?> structure -> objects(structure);
            case Members<?> members ->
                schema(Map.of(
                        "type",
                        "object",
                        "maxProperties",
                        (double) members.limit(),
                        "propertyNames",
                        schemaOf(members.name()),
                        "additionalProperties",
                        schemaOf(members.type())));
            case NamedMaterials _ -> schema(Map.of("type", "string"));
            case NumberOrVector(ValueType.Decimal number, ValueType.Array<Double> vector) ->
                schema(Map.of("anyOf", List.of(schemaOf(number), schemaOf(vector))));
            case TrackTargetType() -> schema(Map.of("type", "string", "pattern", TARGETS));
            case Shaped<?> shaped ->
                schema(Map.of(
                        "if",
                        Map.of("required", List.of(shaped.key())),
                        "then",
                        schemaOf(shaped.keyed()),
                        "else",
                        schemaOf(shaped.plain())));
        };
    }

    private static <R> Map<String, Object> objects(ValueType.Structure<R> structure) {
        Map<String, Object> properties = new TreeMap<>();
        for (Field<R, ?> field : structure.fields()) {
            properties.put(field.name(), property(field, structure.defaults()));
        }
        Map<String, Object> object =
                schema(Map.of("type", "object", "properties", properties, "additionalProperties", false));
        List<Map<String, Object>> either = structure.fields().stream()
                .filter(field -> field.presence() == Field.Presence.EITHER)
                .map(field -> schema(Map.of("required", List.of(field.name()))))
                .toList();
        if (!either.isEmpty()) {
            object.put("oneOf", either);
        }
        if (!structure.names(true).isEmpty()) {
            object.put("required", structure.names(true));
        }
        return object;
    }

    private static <R, T> Map<String, Object> property(Field<R, T> field, R defaults) {
        Map<String, Object> property = schemaOf(field.type());
        boolean isPlain = !"object".equals(property.get("type")) && !"string".equals(property.get("type"));
        if (isPlain
                && !field.isRequired()
                && !Optional.empty().equals(field.get().apply(defaults))) {
            String text = field.type().write(field.get().apply(defaults));
            property.put("default", resolved(JSON.readValue(text, Object.class), Map.of()));
        }
        return property;
    }

    private static Map<String, Object> numbers(String type, Range range) {
        return schema(Map.of("type", type, "minimum", range.min(), "maximum", range.max()));
    }

    private static Map<String, Object> withLeast(String name, int least, Map<String, Object> schema) {
        if (least > 0) {
            schema.put(name, (double) least);
        }
        return schema;
    }

    private static Map<String, Object> schema(Map<String, Object> fields) {
        return new TreeMap<>(fields);
    }
}
