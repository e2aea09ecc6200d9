package dev.twister.threads;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(300)
class BackgroundWriterTest {
    private final CompletableFuture<Void> mayRun = new CompletableFuture<>();

    @Test
    void oneThreadKeepsTheOrder() throws IOException {
        List<Integer> done = Collections.synchronizedList(new ArrayList<>());
        try (BackgroundWriter writer = new BackgroundWriter("test", 1, 2)) {
            for (int i = 0; i < 100; i++) {
                int number = i;
                writer.submit(1, () -> done.add(number));
            }
            writer.finish();
        }

        assertThat(done)
                .containsExactlyElementsOf(IntStream.range(0, 100).boxed().toList());
    }

    @Test
    void neverKeepsMoreThanItsRoom() throws IOException {
        AtomicInteger kept = new AtomicInteger();
        AtomicInteger most = new AtomicInteger();
        try (BackgroundWriter writer = new BackgroundWriter("test", 2, 3)) {
            for (int i = 0; i < 200; i++) {
                writer.submit(1, () -> {
                    most.accumulateAndGet(kept.get(), Math::max);
                    kept.decrementAndGet();
                });
                kept.incrementAndGet();
            }
            writer.finish();
        }

        assertThat(most.get()).isLessThanOrEqualTo(3);
    }

    @Test
    void workLargerThanTheRoomIsDoneAlone() throws IOException {
        try (BackgroundWriter writer = new BackgroundWriter("test", 1, 10)) {
            writer.submit(1, () -> {});
            writer.submit(100, () -> {});
            writer.submit(100, () -> {});
            writer.finish();

            assertThat(writer.written()).isEqualTo(3);
        }
    }

    @Test
    void aFailureIsThrownAndWhatWaitsIsDropped() throws IOException {
        try (BackgroundWriter writer = new BackgroundWriter("test", 1, 10)) {
            writer.submit(1, () -> {
                mayRun.join();
                throw new IOException("disk full");
            });
            writer.submit(1, () -> {});
            mayRun.complete(null);

            assertThatIOException().isThrownBy(writer::finish).withMessage("disk full");
            assertThatIOException().isThrownBy(() -> writer.submit(1, () -> {})).withMessage("disk full");
            assertThat(writer.written()).isZero();
            assertThat(writer.failure()).isPresent();
        }
    }

    @Test
    void workBeforeTheEndIsDoneAndNoneAfterIt() throws IOException {
        try (BackgroundWriter writer = new BackgroundWriter("test", 1, 10)) {
            writer.submit(1, mayRun::join);
            writer.end();

            assertThatIOException().isThrownBy(() -> writer.submit(1, () -> {}));
            assertThat(writer.waiting()).isEqualTo(1);
            mayRun.complete(null);
            writer.finish();
            assertThat(writer.written()).isEqualTo(1);
        }
    }

    @Test
    void theEndFreesACallerThatWaits() throws Exception {
        try (BackgroundWriter writer = new BackgroundWriter("test", 1, 1)) {
            writer.submit(1, mayRun::join);
            CompletableFuture<Void> refused = new CompletableFuture<>();
            Thread caller = Thread.ofPlatform().start(() -> {
                try {
                    writer.submit(1, () -> {});
                } catch (IOException expected) {
                    refused.complete(null);
                }
            });
            while (caller.getState() != Thread.State.WAITING) {
                Thread.sleep(1);
            }
            writer.end();
            refused.join();
            mayRun.complete(null);
        }
    }
}
