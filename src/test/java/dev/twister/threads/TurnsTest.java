package dev.twister.threads;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class TurnsTest {
    private static final int THREADS = 3;

    @Test
    void eachNumberIsHandedOutOnceToWhicheverThread() {
        Turns turns = new Turns(THREADS, 2);
        for (int count : new int[] {0, 1, 2, 5, 1000, 12_345}) {
            AtomicIntegerArray taken = new AtomicIntegerArray(count);
            turns.start(count);
            try (Crew crew = new Crew("test", THREADS, _ -> turns.take(taken::incrementAndGet))) {
                crew.work();
            }
            assertThat(IntStream.range(0, count).filter(number -> taken.get(number) != 1))
                    .isEmpty();
        }
    }

    @Test
    void runsAreLongAtFirstAndShortAtTheEnd() {
        assertThat(runs(new Turns(1, 3), 100)).containsExactly(25, 18, 14, 10, 8, 6, 4, 3, 3, 3, 3, 3);
    }

    @Test
    void theLastRunHasWhatIsLeft() {
        assertThat(runs(new Turns(2, 4), 10)).containsExactly(4, 4, 2);
    }

    @Test
    void theMoreThreadsTheShorterTheRuns() {
        assertThat(runs(new Turns(8, 1), 3200)).startsWith(100, 96);
    }

    /** Returns the length of each run. */
    private static List<Integer> runs(Turns turns, int count) {
        List<Integer> firsts = new ArrayList<>();
        turns.start(count);
        takeFirst(turns, firsts);
        firsts.add(count);
        return IntStream.range(1, firsts.size())
                .mapToObj(run -> firsts.get(run) - firsts.get(run - 1))
                .toList();
    }

    /** A run is taken when its first number starts, so a thread that takes turns then starts with the next run. */
    private static void takeFirst(Turns turns, List<Integer> firsts) {
        AtomicBoolean begun = new AtomicBoolean();
        turns.take(number -> {
            if (!begun.getAndSet(true)) {
                firsts.add(number);
                takeFirst(turns, firsts);
            }
        });
    }
}
