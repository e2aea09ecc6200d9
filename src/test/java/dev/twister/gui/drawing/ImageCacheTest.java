package dev.twister.gui.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.sky.PngBytes;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.TextureImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ImageCacheTest {
    @TempDir
    Path folder;

    private final CountDownLatch begun = new CountDownLatch(1);
    private final CompletableFuture<String> interrupted = new CompletableFuture<>();

    private Skybox readForEver(Path file, Consumer<String> warnings) {
        begun.countDown();
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException _) {
            interrupted.complete("");
        }
        throw new SkyException(file + ": interrupted", new CancellationException());
    }

    @Test
    void whatIsNotWantedAnyMoreIsNotWaitedFor() throws InterruptedException {
        ImageCache cache = new ImageCache(this::readForEver, this::readForEver);
        AtomicBoolean wanted = new AtomicBoolean(true);
        CompletableFuture<Skybox> found =
                CompletableFuture.supplyAsync(() -> cache.find(folder.resolve("slow.hdr"), wanted::get));
        begun.await();
        assertThat(cache.beingRead()).contains(folder.resolve("slow.hdr"));
        wanted.set(false);
        assertThatThrownBy(found::join).hasRootCauseInstanceOf(CancellationException.class);
        interrupted.join();
        assertThat(cache.beingRead()).isEmpty();
    }

    @Test
    void aTextureThatIsNotWantedAnyMoreIsNotWaitedFor() throws InterruptedException {
        ImageCache cache = new ImageCache(this::readForEver, this::readForEver);
        AtomicBoolean wanted = new AtomicBoolean(true);
        CompletableFuture<TextureImage> found =
                CompletableFuture.supplyAsync(() -> cache.texture(folder.resolve("slow.png"), wanted::get));
        begun.await();
        assertThat(cache.beingRead()).contains(folder.resolve("slow.png"));
        wanted.set(false);
        assertThatThrownBy(found::join).hasRootCauseInstanceOf(CancellationException.class);
        interrupted.join();
    }

    @Test
    void whatIsCanceledIsNotWaitedFor() throws InterruptedException {
        ImageCache cache = new ImageCache(this::readForEver, this::readForEver);
        CompletableFuture<Skybox> found =
                CompletableFuture.supplyAsync(() -> cache.find(folder.resolve("slow.hdr"), () -> true));
        begun.await();
        cache.cancel();
        assertThatThrownBy(found::join).hasRootCauseInstanceOf(CancellationException.class);
        interrupted.join();
    }

    @Test
    void givesWarningsOnce() throws IOException {
        byte[] image = PngBytes.start(1, 8, PngBytes.GRAY)
                .damagedChunk("gAMA", new byte[4])
                .texels(0);
        Path file = Files.write(folder.resolve("sky.png"), image);
        ImageCache cache = new ImageCache();
        cache.refresh(file);
        cache.find(file, () -> true);
        assertThat(cache.takeWarnings()).isEqualTo(file + ": the gAMA chunk is damaged and is ignored");
        assertThat(cache.takeWarnings()).isEmpty();
    }
}
