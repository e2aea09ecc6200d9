package dev.twister.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.FrameTimes;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BandTeamTest {
    private static final String DEVICE = "a device of the test's";
    private static final int TRIALS = 15;

    /** By the times of frames that one, two and all three engines render. */
    @ParameterizedTest
    @CsvSource({"6, 58, 90, 1", "60, 30, 20, 3", "60, 30, 45, 2", "60, 59, 58.5, 1", "60, 90, 30, 3"})
    void takesThoseWithWhichFramesAreShortest(double one, double two, double three, int taken) {
        BandTeam team = team(3);
        render(team, TRIALS, one, two, three);

        assertThat(team.taken()).hasSize(taken);
        render(team, 50, one, two, three);
        assertThat(team.taken()).hasSize(taken);
    }

    @Test
    void namesWhoIsLeftOut() {
        BandTeam team = team(2);
        assertThat(team.device()).isEqualTo(DEVICE + " + " + DEVICE);

        render(team, TRIALS, 6, 58);
        assertThat(team.device()).isEqualTo(DEVICE + "; faster without " + DEVICE);
    }

    @Test
    void framesThatChangeAreTriedAnew() {
        BandTeam team = team(2);
        render(team, TRIALS, 6, 58);

        render(team, 4, 60, 30);
        assertThat(team.taken()).hasSize(1);
        render(team, 1, 60, 30);
        assertThat(team.taken()).hasSize(2);
        render(team, TRIALS, 60, 30);
        assertThat(team.taken()).hasSize(2);
    }

    @Test
    void enginesThatBecameFasterJoin() {
        BandTeam team = team(2);
        render(team, TRIALS, 6, 58);
        render(team, 100 + TRIALS, 6, 4);

        assertThat(team.taken()).hasSize(2);
    }

    @Test
    void oneHasNoChoice() {
        BandTeam team = team(1);
        render(team, TRIALS, 6);

        assertThat(team.taken()).hasSize(1);
        assertThat(team.device()).isEqualTo(DEVICE);
    }

    private static BandTeam team(int engines) {
        return new BandTeam(IntStream.range(0, engines)
                .mapToObj(_ -> new BandWorker(new FakeEngine("fake", 0, FrameTimes.onJvm(1))))
                .toList());
    }

    /** Tells of frames whose milliseconds depend on the number of engines. */
    private static void render(BandTeam team, int frames, double... millis) {
        for (int frame = 0; frame < frames; frame++) {
            team.took((long) (1e6 * millis[team.taken().size() - 1]));
        }
    }
}
