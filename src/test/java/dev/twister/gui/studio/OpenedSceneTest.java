package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.Gui;
import dev.twister.scene.Scene;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class OpenedSceneTest {
    private static final Path SCENE = Path.of("scenes", "teaching.json");

    @Test
    void aPanoramaIsAScenesSkyWithoutAnEditOfIt() {
        Path sky = Path.of("skyboxes", "sunset.hdr");
        OpenedScene opened = OpenedScene.readUnder(sky, SCENE);
        Scene own = OpenedScene.read(SCENE).scene();
        assertThat(opened.scene()).isEqualTo(own.withSky(own.sky().withFile(sky.toAbsolutePath())));
        assertThat(opened.file().mark()).isEqualTo(EditedFile.Digest.of(SCENE)).isNotEqualTo(EditedFile.Digest.NONE);
        assertThat(Gui.isPanorama(sky)).isTrue();
        assertThat(Gui.isPanorama(SCENE)).isFalse();
        assertThat(Gui.isPanorama(Path.of("missing.hdr"))).isFalse();
    }
}
