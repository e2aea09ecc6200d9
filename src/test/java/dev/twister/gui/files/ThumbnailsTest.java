package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.WindowDriver;
import dev.twister.gui.files.SceneGallery.Thumbnails;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import javafx.scene.image.Image;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ThumbnailsTest {
    @TempDir
    private Path folder;

    @Test
    void aSceneIsRenderedOnceAndKept() throws IOException {
        Path kept = folder.resolve("kept");
        try (WindowDriver _ = WindowDriver.open();
                Thumbnails thumbnails = new Thumbnails(Optional.of(kept))) {
            CompletableFuture<Image> first = new CompletableFuture<>();
            thumbnails.want(Path.of("scenes", "teaching.json"), first::complete);
            assertThat(first.join().getWidth()).isEqualTo(Thumbnails.WIDTH);
            CompletableFuture<Image> again = new CompletableFuture<>();
            thumbnails.want(Path.of("scenes", "teaching.json"), again::complete);
            assertThat(again.join().getHeight()).isEqualTo(Thumbnails.HEIGHT);
        }
        try (Stream<Path> files = Files.list(kept)) {
            assertThat(files).hasSize(1);
        }
    }
}
