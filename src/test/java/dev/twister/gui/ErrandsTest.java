package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ErrandsTest {
    private final List<String> done = new CopyOnWriteArrayList<>();
    private final CountDownLatch mayEnd = new CountDownLatch(1);

    private boolean doLate() throws InterruptedException {
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
    void theEndDoesNotWaitForWhatIsOnlyRead() throws InterruptedException {
        try (WindowDriver _ = WindowDriver.open()) {
            Errands errands = new Errands();
            errands.run(this::doLate, _ -> {}, _ -> {});
            errands.close();
            assertThat(done).isEmpty();
            mayEnd.countDown();
        }
    }
}
