package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.WindowDriver;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(300)
class BackgroundTasksTest {
    private final List<String> done = new CopyOnWriteArrayList<>();
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch mayEnd = new CountDownLatch(1);

    private boolean doLate() throws InterruptedException {
        begun.countDown();
        mayEnd.await();
        return done.add("late");
    }

    private static void awaitState(Thread thread, Thread.State state) throws InterruptedException {
        while (thread.getState() != state) {
            Thread.sleep(1);
        }
    }

    @Test
    void aSceneIsKeptWhateverElseTakesLong() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            BackgroundTasks tasks = new BackgroundTasks();
            CountDownLatch kept = new CountDownLatch(1);
            tasks.run(this::doLate, _ -> {}, _ -> {});
            tasks.keepPicture(CompletableFuture.completedFuture(""), this::doLate, _ -> {}, _ -> {});
            begun.await();
            tasks.keepFile(
                    () -> {
                        kept.countDown();
                        return "";
                    },
                    _ -> {},
                    _ -> {});
            kept.await();
            assertThat(done).isEmpty();
            mayEnd.countDown();
            tasks.close();
        }
    }

    @Test
    void whatIsToBeKeptIsDoneBeforeTheEnd() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            BackgroundTasks tasks = new BackgroundTasks();
            tasks.keepFile(this::doLate, _ -> {}, _ -> {});
            tasks.keepFile(() -> done.add("kept"), _ -> {}, _ -> {});
            begun.await();
            Thread closing = Thread.ofPlatform().start(tasks::close);
            awaitState(closing, Thread.State.TIMED_WAITING);
            mayEnd.countDown();
            closing.join();

            assertThat(done).containsExactly("late", "kept");
        }
    }

    @Test
    void aPictureThatNeedsSomethingHoldsUpNoOtherAndIsWaitedFor() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            BackgroundTasks tasks = new BackgroundTasks();
            CompletableFuture<String> needed = new CompletableFuture<>();
            CountDownLatch saved = new CountDownLatch(1);
            tasks.keepPicture(needed, () -> done.add("with what it needs"), _ -> {}, _ -> {});
            tasks.keepPicture(
                    CompletableFuture.completedFuture(""),
                    () -> {
                        done.add("at once");
                        saved.countDown();
                        return "";
                    },
                    _ -> {},
                    _ -> {});
            saved.await();
            Thread closing = Thread.ofPlatform().start(tasks::close);
            awaitState(closing, Thread.State.WAITING);
            needed.complete("");
            closing.join();

            assertThat(done).containsExactly("at once", "with what it needs");
        }
    }

    @Test
    void theEndDoesNotWaitForWhatIsNotKept() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            BackgroundTasks tasks = new BackgroundTasks();
            tasks.run(this::doLate, _ -> {}, _ -> {});
            begun.await();
            tasks.close();
            assertThat(done).isEmpty();
            mayEnd.countDown();
        }
    }
}
