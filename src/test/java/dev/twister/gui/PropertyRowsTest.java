package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.panel.PanelRow;
import dev.twister.kernel.Layout;
import dev.twister.mesh.gltf.AnimatedGltf;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Scene;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.LightProperties;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every property of a scene can be set in the window and is described. */
class PropertyRowsTest {
    /** Names of properties without a row, and where the window has them. */
    private static final Map<String, String> ELSEWHERE = Map.of(
            "width", "the size of the picture is asked for where it is rendered to a file",
            "height", "as the width",
            "type", "a light's kind is chosen where it is added");

    private static final List<String> ENDINGS = List.of("", " x", " y", " z", " yaw", " pitch", " roll");

    @TempDir
    private Path folder;

    @Test
    void everyPropertyHasARowAndALineInTheDescription() throws Exception {
        Set<String> rows = rows();
        String description = Files.readString(Path.of("docs", "scene-format.md"));

        assertThat(properties())
                .allSatisfy(
                        property -> assertThat(description).as(property.name()).contains("`" + property.name() + "`"))
                .filteredOn(property -> !property.row().label().isEmpty() || !ELSEWHERE.containsKey(property.name()))
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
                        List.of(BodyProperties.ANIMATION_NAME),
                        BodyProperties.ANIMATION,
                        SceneProperties.SKY,
                        SceneProperties.SHADING,
                        SceneProperties.RENDERING,
                        SceneProperties.PHYSICS)
                .flatMap(List::stream);
    }

    /** The names of the rows of all kinds of bodies. */
    private Set<String> rows() throws IOException {
        Scene tiny = WindowScenes.tiny();
        Path vase = Path.of("scenes", "meshes", "vase.obj").toAbsolutePath().normalize();
        Files.writeString(folder.resolve("a.gltf"), AnimatedGltf.example());
        Mesh moving = Mesh.of(folder.resolve("a.gltf")).withAnimation(MeshAnimation.of("move"));
        Scene scene = tiny.withMeshes(
                List.of(Mesh.of(vase).withMaterial(Material.DEFAULT), moving.withMaterial(Material.DEFAULT)));
        Set<String> names = new TreeSet<>();
        try (WindowDriver driver = WindowDriver.open(scene, BlockEngine.offer())) {
            driver.await(() -> driver.studio.bodies().meshes().holds(moving));
            for (int body :
                    new int[] {Layout.FIRST_SPHERE, BodyNumber.ofMesh(0), BodyNumber.ofMesh(1), BodyNumber.PLANE}) {
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
