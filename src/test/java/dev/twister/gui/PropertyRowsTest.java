package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.panel.PanelRow;
import dev.twister.kernel.Layout;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every property of a scene can be set in the window and is described. */
class PropertyRowsTest {
    /** Properties without a row of their name, and where the window has them. */
    private static final Map<Property<?, ?>, String> ELSEWHERE = Map.of(
            SceneProperties.WIDTH, "the size of the picture is asked for where it is rendered to a file",
            SceneProperties.HEIGHT, "as the width");

    private static final List<String> ENDINGS = List.of("", " x", " y", " z", " yaw", " pitch", " roll");

    @Test
    void everyPropertyHasARowAndALineInTheDescription() throws Exception {
        Set<String> rows = rows();
        String description = Files.readString(Path.of("docs", "scene-format.md"));

        assertThat(properties())
                .allSatisfy(
                        property -> assertThat(description).as(property.name()).contains("`" + property.name() + "`"))
                .filteredOn(property -> !ELSEWHERE.containsKey(property))
                .allSatisfy(property -> assertThat(ENDINGS)
                        .as(property.name() + ", a row " + property.row().label())
                        .anyMatch(ending -> rows.contains(property.row().label() + ending)));
    }

    private static Stream<Property<?, ?>> properties() {
        return Stream.of(
                        CameraProperties.ALL,
                        LightProperties.ALL,
                        MaterialProperties.ALL,
                        BodyProperties.SPHERE,
                        BodyProperties.MESH,
                        List.of(BodyProperties.SMOOTH, BodyProperties.ODD_COLOR),
                        BodyProperties.PLANE,
                        SceneProperties.SKY,
                        SceneProperties.SHADING,
                        SceneProperties.RENDERING,
                        SceneProperties.PHYSICS)
                .flatMap(List::stream);
    }

    /** The names of the rows of all kinds of bodies. */
    private static Set<String> rows() {
        Scene tiny = WindowScenes.tiny();
        Path vase = Path.of("scenes", "meshes", "vase.obj").toAbsolutePath().normalize();
        Scene scene = tiny.withMeshes(List.of(Mesh.of(vase).withMaterial(Material.DEFAULT)));
        Set<String> names = new TreeSet<>();
        try (WindowDriver driver = WindowDriver.open(scene, BlockEngine.offer())) {
            for (int body : new int[] {Layout.FIRST_SPHERE, BodyNumber.ofMesh(0), BodyNumber.PLANE}) {
                driver.run(() -> driver.studio.selection().select(body));
                driver.pulse();
                WindowDriver.call(() -> driver.window.workbench().panel().rows().stream()
                                .map(PanelRow::name)
                                .toList())
                        .forEach(names::add);
            }
        }
        return names;
    }
}
