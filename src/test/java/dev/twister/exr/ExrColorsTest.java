package dev.twister.exr;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ExrColorsTest {
    @Test
    void areThoseWithoutALayer() {
        assertThat(ExrColors.of(List.of("A", "B", "G", "R", "albedo.B", "albedo.G", "albedo.R")))
                .containsExactly("R", "G", "B");
        assertThat(ExrColors.of(List.of(".B", ".G", ".R"))).containsExactly(".R", ".G", ".B");
        assertThat(ExrColors.of(List.of("b", "g", "r"))).containsExactly("r", "g", "b");
    }

    @Test
    void areThoseOfTheLayerThatIsThePicture() {
        assertThat(ExrColors.of(List.of(
                        "ViewLayer.AO.B",
                        "ViewLayer.AO.G",
                        "ViewLayer.AO.R",
                        "ViewLayer.Combined.A",
                        "ViewLayer.Combined.B",
                        "ViewLayer.Combined.G",
                        "ViewLayer.Combined.R",
                        "ViewLayer.Depth.Z")))
                .containsExactly("ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B");
        assertThat(ExrColors.of(List.of("rgba.alpha", "rgba.blue", "rgba.green", "rgba.red")))
                .containsExactly("rgba.red", "rgba.green", "rgba.blue");
        assertThat(ExrColors.of(List.of("x.B", "x.G", "x.R", "y.B", "y.G", "y.R")))
                .containsExactly("x.R", "x.G", "x.B");
    }

    @Test
    void oneChannelIsGray() {
        assertThat(ExrColors.of(List.of("A", "Y"))).containsExactly("Y", "Y", "Y");
        assertThat(ExrColors.of(List.of("Z"))).containsExactly("Z", "Z", "Z");
        assertThat(ExrColors.of(List.of("U", "V"))).isEmpty();
    }
}
