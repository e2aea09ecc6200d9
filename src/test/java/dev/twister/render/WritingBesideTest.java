package dev.twister.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class WritingBesideTest {
    @Test
    void oneThreadKeepsTheOrder() throws IOException {
        List<Integer> done = Collections.synchronizedList(new ArrayList<>());
        try (WritingBeside writing = new WritingBeside(1)) {
            for (int i = 0; i < 100; i++) {
                int number = i;
                writing.submit(() -> done.add(number));
            }
            writing.finish();
        }

        assertThat(done)
                .containsExactlyElementsOf(IntStream.range(0, 100).boxed().toList());
    }

    @Test
    void neverKeepsMoreThanItSays() throws IOException {
        AtomicInteger kept = new AtomicInteger();
        AtomicInteger most = new AtomicInteger();
        try (WritingBeside writing = new WritingBeside(2)) {
            for (int i = 0; i < 200; i++) {
                writing.submit(() -> {
                    most.accumulateAndGet(kept.get(), Math::max);
                    kept.decrementAndGet();
                });
                kept.incrementAndGet();
            }
            writing.finish();
        }

        assertThat(most.get()).isLessThanOrEqualTo(WritingBeside.waiting(2));
    }

    @Test
    void tellsWhatFailed() {
        assertThatIOException()
                .isThrownBy(() -> {
                    try (WritingBeside writing = new WritingBeside(1)) {
                        writing.submit(() -> {
                            throw new IOException("disk full");
                        });
                        writing.finish();
                    }
                })
                .withMessage("disk full");
    }
}
