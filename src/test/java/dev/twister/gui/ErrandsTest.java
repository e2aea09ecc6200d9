package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(300)
class ErrandsTest {
    private final List<String> done = new CopyOnWriteArrayList<>();
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch mayEnd = new CountDownLatch(1);

    private boolean doLate() throws InterruptedException {
        begun.countDown();
        mayEnd.await();
        return done.add("begun before");
    }

    @Test
    void whatIsToBeKeptIsDoneBeforeTheEnd() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            Errands errands = new Errands();
            errands.run(this::doLate, _ -> {}, _ -> {});
            errands.run(() -> done.add("not begun"), _ -> {}, _ -> {});
            errands.keep(() -> done.add("kept"), _ -> {}, _ -> {});
            begun.await();
            Thread closing = Thread.ofPlatform().start(errands::close);
            while (closing.getState() != Thread.State.TIMED_WAITING) {
                Thread.sleep(1);
            }
            mayEnd.countDown();
            closing.join();

            assertThat(done).containsExactly("begun before", "kept");
        }
    }

    @Test
    void whatNeedsSomethingHoldsUpNothingAndIsWaitedFor() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            Errands errands = new Errands();
            CompletableFuture<String> needed = new CompletableFuture<>();
            CountDownLatch saved = new CountDownLatch(1);
            errands.keepAfter(needed, () -> done.add("with what it needs"), _ -> {}, _ -> {});
            errands.keep(
                    () -> {
                        done.add("at once");
                        saved.countDown();
                        return "";
                    },
                    _ -> {},
                    _ -> {});
            saved.await();
            Thread closing = Thread.ofPlatform().start(errands::close);
            while (closing.getState() != Thread.State.WAITING) {
                Thread.sleep(1);
            }
            needed.complete("");
            closing.join();

            assertThat(done).containsExactly("at once", "with what it needs");
        }
    }

    @Test
    void theEndDoesNotWaitForWhatIsOnlyRead() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            Errands errands = new Errands();
            errands.run(this::doLate, _ -> {}, _ -> {});
            begun.await();
            errands.close();
            assertThat(done).isEmpty();
            mayEnd.countDown();
        }
    }
}
