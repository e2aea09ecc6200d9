package dev.twister.engine.auto;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ChoiceStoreTest {
    private static final List<String> ENGINES = List.of("sequential", "parallel", "vector");
    private static final MachineKey KEY = new MachineKey(Map.of("cores", "2", "twister", "test"));

    @TempDir
    private Path folder;

    @Test
    void aChoiceIsReadWholeWhileOthersWriteTheirs() {
        ChoiceStore store = new ChoiceStore(Optional.of(folder));
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
