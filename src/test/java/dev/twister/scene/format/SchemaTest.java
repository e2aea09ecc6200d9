package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Scene;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Range;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
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
    void theShippedSchemaIsMadeFromTheFormat() throws Exception {
        Path file = Path.of("scenes", "scene.schema.json");
        Map<String, Object> shipped = JSON.readValue(Files.readString(file), Map.class);
        Map<String, Object> schema = new LinkedHashMap<>();
        schema.put("$schema", shipped.get("$schema"));
        schema.put("title", shipped.get("title"));
        schema.putAll(schemaOfScenes());
        describe(schema, shipped, (Map<String, Object>) shipped.get("$defs"));
        String text = text(SchemaDefinitions.of(schema));
        if (Boolean.getBoolean("twister.schema.update")) {
            Files.writeString(file, text);
        }

        assertThat(Files.readString(file))
                .as("./mvnw -Dtest=SchemaTest -Dtwister.schema.update=true package writes it anew")
                .isEqualTo(text);
    }

    private static String text(Object schema) {
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsString(schema).replace("\r", "") + "\n";
    }

    /** What the table of properties does not tell is as the shipped schema says. */
    @SuppressWarnings("unchecked") // JSON objects
    private static void describe(Map<String, Object> made, Map<?, ?> shipped, Map<String, Object> definitions) {
        Map<?, ?> resolved = shipped;
        while (resolved.get("$ref") instanceof String reference) {
            Map<Object, Object> together =
                    new LinkedHashMap<>((Map<?, ?>) definitions.get(reference.substring(DEFINITION.length())));
            resolved.forEach((key, value) -> {
                if (!"$ref".equals(key)) {
                    together.put(key, value);
                }
            });
            resolved = together;
        }
        if (resolved.get("description") instanceof String text && !made.containsKey("description")) {
            made.put("description", text);
        }
        Map<?, ?> known = resolved;
        made.forEach((key, value) -> {
            if (value instanceof Map<?, ?> child
                    && known.get(key) instanceof Map<?, ?> old
                    && !"description".equals(key)) {
                describe((Map<String, Object>) child, old, definitions);
            }
        });
    }

    /** Fields of the newest version that older versions lack. */
    private static Map<String, Object> schemaOfScenes() {
        Map<String, Object> schema = schemaOf(format(Scene.VERSION).scene());
        List<Map<String, Object>> older = new ArrayList<>();
        for (int version = 1; version < Scene.VERSION; version++) {
            older.add(schema(Map.of(
                    "if",
                    Map.of("properties", Map.of("version", Map.of("const", version))),
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

    private static Map<String, Object> schemaOf(ValueType<?> type) {
        return switch (type) {
            case ValueType.Decimal(Range range) -> numbers("number", range);
            case ValueType.WholeNumber(Range range) -> numbers("integer", range);
            case ReflectivityType _ -> numbers("number", MaterialProperties.REFLECTIVITY.range());
            case ValueType.Flag() -> schema(Map.of("type", "boolean"));
            case ValueType.Text(int min, int max) ->
                withLeast(
                        "minLength",
                        min,
                        schema(Map.of("type", "string", "maxLength", max, "pattern", NO_CONTROL_CHARACTERS)));
            case ValueType.GroupName() -> schema(Map.of("type", "string", "pattern", "^[A-Za-z0-9_-]{0,20}$"));
            case ValueType.FilePath(ValueType.Text text, NamedFiles _) -> schemaOf(text);
            case ValueType.Version(int newest) ->
                schema(Map.of("enum", IntStream.rangeClosed(1, newest).boxed().toList()));
            case ValueType.Choice<?> choice -> schema(Map.of("enum", choice.names()));
            case ValueType.Array<?> array ->
                withLeast(
                        "minItems",
                        array.minItems(),
                        schema(Map.of("type", "array", "items", schemaOf(array.item()), "maxItems", array.maxItems())));
            case ValueType.Lines<?>(ValueType.Array<?> array) -> schemaOf(array);
            case ValueType.Converted<?, ?> converted -> schemaOf(converted.stored());
            case ValueType.Structure<?> structure -> objects(structure);
            case Members<?> members ->
                schema(Map.of(
                        "type",
                        "object",
                        "maxProperties",
                        members.limit(),
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
        Map<String, Object> properties = new LinkedHashMap<>();
        for (Field<R, ?> field : structure.fields()) {
            properties.put(field.name(), property(field, structure.defaults()));
        }
        Map<String, Object> object =
                schema(Map.of("type", "object", "properties", properties, "additionalProperties", false));
        List<String> either = structure.fields().stream()
                .filter(field -> field.presence() == Field.Presence.EITHER)
                .map(Field::name)
                .toList();
        if (!either.isEmpty()) {
            object.put("not", schema(Map.of("required", either)));
        }
        if (!structure.names(true).isEmpty()) {
            object.put("required", structure.names(true));
        }
        return object;
    }

    private static <R, T> Map<String, Object> property(Field<R, T> field, R defaults) {
        Map<String, Object> property = schemaOf(field.type());
        if (!field.meaning().isEmpty()) {
            property.put("description", sentence(field));
        }
        boolean isPlain = !"object".equals(property.get("type")) && !"string".equals(property.get("type"));
        if (isPlain
                && !field.isRequired()
                && !Optional.empty().equals(field.get().apply(defaults))) {
            String text = field.type().write(field.get().apply(defaults));
            property.put("default", JSON.readValue(text, Object.class));
        }
        return property;
    }

    private static Object number(double number) {
        if (number == Math.rint(number)) {
            return (long) number;
        }
        return number;
    }

    private static String sentence(Field<?, ?> field) {
        String plain = field.meaning().replace("`", "").replaceAll("\\[([^]]*)]\\([^)]*\\)", "$1");
        return plain.substring(0, 1).toUpperCase(Locale.ROOT) + plain.substring(1) + ".";
    }

    private static Map<String, Object> numbers(String type, Range range) {
        return schema(Map.of("type", type, "minimum", number(range.min()), "maximum", number(range.max())));
    }

    private static Map<String, Object> withLeast(String name, int least, Map<String, Object> schema) {
        if (least > 0) {
            schema.put(name, least);
        }
        return schema;
    }

    private static Map<String, Object> schema(Map<String, Object> fields) {
        Map<String, Object> ordered = new LinkedHashMap<>();
        new TreeMap<>(fields).forEach(ordered::put);
        return ordered;
    }
}
