package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Physics;
import dev.twister.scene.Rendering;
import dev.twister.scene.Shading;
import dev.twister.scene.Sky;
import dev.twister.scene.Sphere;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.PropertyType;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.SceneProperties;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The tables of the format's description are those of the properties. */
class FormatTablesTest {
    private static final Path DESCRIPTION = Path.of("docs", "scene-format.md");
    private static final String HEAD = "| field | range | default | since | meaning |\n|---|---|---|---|---|\n";

    @Test
    void theDescriptionHasTheTablesOfTheProperties() throws Exception {
        String shipped = Files.readString(DESCRIPTION);
        String text = shipped;
        for (Map.Entry<String, String> table : tables().entrySet()) {
            String begin = "<!-- " + table.getKey() + " -->\n";
            int from = text.indexOf(begin) + begin.length();
            assertThat(text).contains(begin);
            int to = text.indexOf("\n\n", from) + 1;
            text = text.substring(0, from) + table.getValue() + text.substring(to);
        }
        if (Boolean.getBoolean("twister.schema.update")) {
            Files.writeString(DESCRIPTION, text);
        }

        assertThat(Files.readString(DESCRIPTION))
                .as("./mvnw -Dtest=FormatTablesTest -Dtwister.schema.update=true package writes it anew")
                .isEqualTo(text);
    }

    private static Map<String, String> tables() {
        Map<String, String> tables = new LinkedHashMap<>();
        tables.put("camera", table(Camera.USUAL, CameraProperties.ALL));
        tables.put("light", table(Light.DEFAULT, LightProperties.ALL));
        tables.put("material", table(Material.DEFAULT, MaterialProperties.ALL));
        tables.put("sphere", table(Sphere.DEFAULT, BodyProperties.SPHERE));
        tables.put(
                "mesh",
                table(
                        Mesh.DEFAULT,
                        Stream.concat(BodyProperties.MESH.stream(), Stream.of(BodyProperties.SMOOTH))
                                .toList()));
        tables.put(
                "animation",
                table(
                        MeshAnimation.NONE,
                        Stream.concat(Stream.of(BodyProperties.ANIMATION_NAME), BodyProperties.ANIMATION.stream())
                                .toList()));
        tables.put("plane", table(Ground.DEFAULT, BodyProperties.PLANE));
        tables.put("sky", table(Sky.of(Path.of("")), SceneProperties.SKY));
        tables.put("shading", table(Shading.DEFAULT, SceneProperties.SHADING));
        tables.put("rendering", table(Rendering.DEFAULT, SceneProperties.RENDERING));
        tables.put("physics", table(Physics.DEFAULT, SceneProperties.PHYSICS));
        return tables;
    }

    private static <T> String table(T defaults, List<Property<T, ?>> properties) {
        return HEAD
                + properties.stream().map(property -> line(defaults, property)).collect(Collectors.joining());
    }

    private static <T, V> String line(T defaults, Property<T, V> property) {
        V usual = property.getter().apply(defaults);
        String text = property.getter().apply(defaults).equals(Optional.empty())
                ? "none"
                : ValueType.of(property.type(), NamedFiles.UNRESOLVED).write(usual);
        String shown = text.equals("\"\"") || text.equals("none") ? "none" : "`" + text.replace("\"", "") + "`";
        return "| `" + property.name() + "` | " + range(property.type()) + " | " + shown + " | " + property.since()
                + " | " + property.meaning() + " |\n";
    }

    private static String range(PropertyType<?> type) {
        return switch (type) {
            case PropertyType.Numbers<?> numbers -> text(numbers.range()) + (numbers.count() == 1 ? "" : " each");
            case PropertyType.Flag() -> "`true`, `false`";
            case PropertyType.Choice<?> choice ->
                choice.values().stream()
                        .map(value -> "`" + PropertyType.Choice.name(value) + "`")
                        .collect(Collectors.joining(", "));
            case PropertyType.LayerName() -> "up to " + LightGroup.MAX_NAME_LENGTH + " of A-Z, a-z, 0-9, - and _";
            case PropertyType.ClipName() -> "a name";
            case PropertyType.Image() -> "a file";
            case PropertyType.Given<?>(PropertyType<?> given) -> range(given);
        };
    }

    private static String text(Range range) {
        String unit = switch (range.unit()) {
            case "meters" -> " m";
            case "degrees" -> "°";
            case "m^2" -> " m²";
            case "m/s^2" -> " m/s²";
            default -> range.unit().isEmpty() ? "" : " " + range.unit();
        };
        return number(range.min()) + " to " + number(range.max()) + unit;
    }

    private static String number(double number) {
        double exponent = Math.log10(Math.abs(number));
        boolean power = Double.isFinite(exponent) && Math.abs(exponent) >= 5 && exponent == Math.rint(exponent);
        return power
                ? (number < 0 ? "-" : "") + "10^" + (int) exponent
                : BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }
}
