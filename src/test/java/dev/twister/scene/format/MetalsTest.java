package dev.twister.scene.format;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.format.json.SourceText;
import dev.twister.scene.material.Reflectance;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A metal is a metal at every reflectivity from version 4 on; older files mean what they meant. */
class MetalsTest {
    private static Scene scene(int version, String material, String more) {
        return SceneDocument.parse(
                SourceText.unwritten("metals.json", """
                        {"version": %d, "skybox": "sky.hdr",
                         "spheres": [{"position": [0, 1, 0], "radius": 1, %s}]%s}
                        """.formatted(version, material, more)), NamedFiles.UNRESOLVED);
    }

    private static Material material(Scene scene) {
        return scene.spheres().getFirst().material();
    }

    private static String written(Scene scene) {
        return SceneDocument.of(scene, NamedFiles.UNRESOLVED, Optional.empty());
    }

    @ParameterizedTest
    @CsvSource({"5", "100"})
    void aMetalBesideAReflectivityIsOneFromVersionFourOn(double reflectivity) {
        String text = "\"metallic\": 1, \"roughness\": 0.25, \"reflectivity\": " + reflectivity;

        Material metal = material(scene(4, text, ""));
        Material tinted = material(scene(3, text, ""));

        assertThat(metal.isMetalOverMirror()).isTrue();
        assertThat(metal.whittedReflectivity()).isEqualTo(Math.max(reflectivity, 72));
        assertThat(tinted.reflectance()).isEqualTo(Reflectance.TINTED);
        assertThat(tinted.isMetalOverMirror()).isFalse();
        assertThat(tinted.whittedReflectivity()).isEqualTo(reflectivity);
    }

    @Test
    void aReflectivityOfZeroIsGivenFromVersionFourOn() {
        String rough = "\"roughness\": 0.5";
        assertThat(material(scene(4, rough, "")).isByFresnel()).isTrue();
        assertThat(material(scene(4, rough + ", \"reflectivity\": 0", "")).isByFresnel())
                .isFalse();
        assertThat(material(scene(3, rough + ", \"reflectivity\": 0", "")).isByFresnel())
                .isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            quoteCharacter = '|',
            value = {
                "1; 'reflectivity': 5; 1",
                "2; 'reflectivity': 0, 'roughness': 0.5; 2",
                "3; 'reflectivity': 5, 'metallic': 1; 3",
                "3; 'reflectivity': 0, 'metallic': 1; 3",
                "4; 'metallic': 1; 3",
                "4; 'roughness': 0.5; 2",
                "4; 'reflectivity': 5, 'metallic': 1; 4",
                "4; 'reflectivity': 0, 'metallic': 1; 4",
                "4; 'reflectivity': 0, 'roughness': 1; 4",
                "4; 'reflectivity': 5, 'metallic': 1, 'tinted': true; 3"
            })
    void whatIsWrittenMeansTheSameAndStaysTheSame(int version, String material, int needed) {
        Scene scene = scene(version, material.replace('\'', '"'), "");

        String text = written(scene);
        Scene again = SceneDocument.parse(SourceText.unwritten("again.json", text), NamedFiles.UNRESOLVED);

        assertThat(text).contains("\"version\": " + needed + ",");
        assertThat(again).isEqualTo(scene);
        assertThat(written(again)).isEqualTo(text);
    }

    @Test
    void aTrackOfAnOlderFileOnlyTints() {
        Scene scene = scene(
                3,
                "\"reflectivity\": 5",
                ", \"tracks\": [{\"target\": \"spheres[0]\", \"property\": \"metallic\","
                        + " \"keyframes\": [{\"time\": 1, \"value\": 1}]}]");

        assertThat(material(scene).withMetallic(1).isMetalOverMirror()).isFalse();
        assertThat(written(scene)).contains("\"version\": 3,");
    }

    @Test
    void withOtherThingsOfVersionFourATintIsSaid() {
        Scene scene = scene(
                4,
                "\"reflectivity\": 5, \"metallic\": 1, \"tinted\": true},"
                        + " {\"position\": [3, 1, 0], \"radius\": 1, \"reflectivity\": 5, \"metallic\": 1",
                "");

        assertThat(written(scene)).contains("\"tinted\": true").contains("\"version\": 4,");
    }
}
