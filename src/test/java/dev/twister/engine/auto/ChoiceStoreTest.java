package dev.twister.engine.auto;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ChoiceStoreTest {
    private static final List<String> ENGINES = List.of("sequential", "parallel", "vector");
    private static final MachineKey KEY = new MachineKey(Map.of("cores", "2", "twister", "test"));

    @TempDir
    private Path folder;

    private ChoiceStore at(Instant now) {
        return new ChoiceStore(Optional.of(folder), Clock.fixed(now, ZoneOffset.UTC));
    }

    @ParameterizedTest
    @CsvSource({"29, true", "30, false"})
    void aChoiceIsForgottenAfterAMonth(int days, boolean known) {
        at(Instant.EPOCH).write(KEY, "vector");

        ChoiceStore later = at(Instant.EPOCH.plus(days, ChronoUnit.DAYS));
        assertThat(later.read(KEY).isPresent()).isEqualTo(known);
        assertThat(later.day(KEY)).contains(LocalDate.EPOCH);
    }

    @Test
    void aNewMeasurementRenewsTheDay() {
        at(Instant.EPOCH).write(KEY, "vector");
        at(Instant.EPOCH.plus(20, ChronoUnit.DAYS)).write(KEY, "vector");

        assertThat(at(Instant.EPOCH).day(KEY)).contains(LocalDate.EPOCH.plusDays(20));
    }

    @Test
    void aChoiceIsReadWholeWhileOthersWriteTheirs() {
        ChoiceStore store = at(Instant.EPOCH);
        store.write(KEY, ENGINES.getFirst());
        List<Optional<String>> read = IntStream.range(0, 300)
                .parallel()
                .mapToObj(number -> {
                    store.write(KEY, ENGINES.get(number % ENGINES.size()));
                    return store.read(KEY);
                })
                .toList();

        assertThat(read).allMatch(choice -> choice.filter(ENGINES::contains).isPresent());
    }
}
