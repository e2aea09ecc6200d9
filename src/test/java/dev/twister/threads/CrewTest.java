package dev.twister.threads;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

// A thread that spins or parks as a crew does ignores interruption, so timeouts need a separate thread.
@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class CrewTest {
    private static final int THREADS = 3;

    @Test
    void eachThreadDoesTheJobOnceARound() {
        AtomicIntegerArray done = new AtomicIntegerArray(THREADS);
        try (Crew crew = new Crew("test", THREADS, done::incrementAndGet)) {
            for (int round = 1; round <= 100; round++) {
                crew.work();
                for (int thread = 0; thread < THREADS; thread++) {
                    assertThat(done.get(thread)).isEqualTo(round);
                }
            }
        }
    }

    @Test
    void whatFailsOnOneThreadIsToldAndTheOthersWork() {
        try (Crew crew = new Crew("test", THREADS, number -> {
            if (number == 1) {
                throw new IllegalArgumentException("spoilt");
            }
        })) {
            assertThatThrownBy(crew::work)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("spoilt");
            assertThatThrownBy(crew::work).hasMessageContaining("spoilt");
        }
    }

    @Test
    void tooLittleMemoryOnOneThreadIsToldAsSuch() {
        OutOfMemoryError problem = new OutOfMemoryError("Java heap space");
        try (Crew crew = new Crew("test", THREADS, number -> {
            if (number == 1) {
                throw problem;
            }
        })) {
            assertThatThrownBy(crew::work).isSameAs(problem);
        }
    }

    @Test
    void aClosedOneSaysSo() {
        Crew crew = new Crew("test", THREADS, _ -> {});
        crew.work();
        crew.close();
        assertThatThrownBy(crew::work).isInstanceOf(IllegalStateException.class).hasMessageContaining("closed");
    }

    @Test
    void oneThatIsClosedWhileItWorksComesToAnEnd() {
        Crew[] closing = new Crew[1];
        closing[0] = new Crew("test", THREADS, number -> {
            if (number == 0) {
                closing[0].close();
            }
        });
        closing[0].work();
        assertThatThrownBy(closing[0]::work).hasMessageContaining("closed");
    }
}
