package dev.twister.gui.rendering;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.engine.EngineOffer;
import dev.twister.gui.edit.Scenes;
import dev.twister.gui.rendering.WindowOrder.FilmMotion;
import dev.twister.gui.rendering.WindowOrder.FilmPlan;
import dev.twister.gui.rendering.WindowOrder.MovingScene;
import dev.twister.render.FrameRange;
import dev.twister.render.RenderOrder;
import dev.twister.scene.Scene;
import dev.twister.world.StageOrView;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Jobs that render by an engine that tells of each frame. */
class RenderJobTest {
    private final AtomicLong nanos = new AtomicLong();
    private final CompletableFuture<RenderJob> running = new CompletableFuture<>();

    @TempDir
    private Path folder;

    @Test
    void tellsHowFarItIs() {
        List<String> told = new ArrayList<>();
        List<Double> parts = new ArrayList<>();

        start("film.apng", 3, _ -> {
            RenderJob.JobProgress progress = running.join().progress();
            told.add(progress.text());
            parts.add(progress.part().orElseThrow());
            nanos.addAndGet(TimeUnit.SECONDS.toNanos(40));
        });
        running.join().result().join();

        assertThat(told).containsExactly("Frame 1 of 3", "Frame 2 of 3 · 1 min 20 s left", "Frame 3 of 3 · 40 s left");
        assertThat(parts).containsExactly(0.0, 1 / 3.0, 2 / 3.0);
        assertThat(running.join().progress().part()).contains(1.0);
    }

    @Test
    void timeLeftCountsDownBetweenFrames() {
        List<String> told = new ArrayList<>();

        start("film.apng", 2, frame -> {
            nanos.addAndGet(TimeUnit.SECONDS.toNanos(10));
            told.add(running.join().progress().text());
            nanos.addAndGet(TimeUnit.SECONDS.toNanos(frame == 0 ? 0 : 20));
            told.add(running.join().progress().text());
        });
        running.join().result().join();

        assertThat(told)
                .containsExactly("Frame 1 of 2", "Frame 1 of 2", "Frame 2 of 2 · 0 s left", "Frame 2 of 2 · 0 s left");
    }

    @Test
    void aCanceledFilmLeavesNoFile() {
        start("film.apng", 5, cancelAt(2));

        assertCanceled();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aCanceledPictureLeavesNoFile() {
        start("picture.png", 1, cancelAt(0));

        assertCanceled();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void canceledFramesAreWholeAsFarAsTheyAre() {
        start("f-####.png", 5, cancelAt(2));

        assertCanceled();
        assertThat(folder.toFile().list()).isSubsetOf("f-0000.png", "f-0001.png", "f-0002.png");
        assertThat(folder.resolve("f-0000.png")).exists();
    }

    @Test
    void renderingEndsBeforeTheFirstFrameWhereItIsCanceledWhileTheSceneIsRead() {
        RenderOrder order = order("picture.png", 1, _ -> {
            throw new AssertionError("no frame is wanted");
        });
        CompletableFuture<Boolean> canceled = new CompletableFuture<>();
        RenderJob job = RenderJob.start(
                order,
                () -> {
                    canceled.join();
                    return World.of(order.scene(), Scenes.SKY);
                },
                nanos::get);
        assertThat(job.progress().text()).isEqualTo("Reading the scene…");
        job.cancel();
        canceled.complete(true);

        assertThatThrownBy(job.result()::join).isInstanceOf(CancellationException.class);
    }

    @Test
    void tellsWhatFailed() {
        start("missing/picture.png", 1, _ -> {});

        assertThatExceptionOfType(CompletionException.class)
                .isThrownBy(running.join().result()::join)
                .withCauseInstanceOf(IOException.class)
                .withMessageContaining("there is no folder");
    }

    private IntConsumer cancelAt(int frame) {
        return number -> {
            if (number == frame) {
                running.join().cancel();
            }
        };
    }

    private void assertCanceled() {
        assertThatThrownBy(running.join().result()::join).isInstanceOf(CancellationException.class);
        assertThat(running.join().isCanceled()).isTrue();
    }

    private void start(String name, int frames, IntConsumer watcher) {
        RenderOrder order = order(name, frames, watcher);
        running.complete(RenderJob.start(order, () -> World.of(order.scene(), Scenes.SKY), nanos::get));
    }

    private RenderOrder order(String name, int frames, IntConsumer watcher) {
        Scene scene = Scenes.scene();
        EngineOffer engine = WatchedEngine.offer(watcher);
        Path file = folder.resolve(name);
        FilmPlan film = new FilmPlan(FilmMotion.PHYSICS, 30, FrameRange.ofCount(frames));
        return frames > 1
                ? WindowOrder.film(scene, StageOrView.BEAUTY, engine, film, file)
                : WindowOrder.picture(
                        new MovingScene(_ -> scene, 1), StageOrView.BEAUTY, engine, Optional.empty(), file);
    }
}
