package dev.twister.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.bench.MachineInfo;
import dev.twister.bench.PaperPlan;
import dev.twister.bench.PaperReport;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeptNumbersTest {
    private static final PaperReport REPORT = new PaperReport(
            MachineInfo.ofThisMachine(),
            PaperPlan.quick(List.of("sequential")),
            "test",
            List.of(),
            List.of(),
            List.of(),
            false);

    @TempDir
    private Path folder;

    @Test
    void saysWhereTheNumbersAre() {
        KeptNumbers kept = new KeptNumbers(folder);
        kept.keep(REPORT);

        assertThat(kept.end())
                .contains(
                        folder.resolve("paper-unfinished.json").toString(),
                        folder.resolve("paper-unfinished.csv").toString());
        assertThat(folder.resolve("paper-unfinished.json")).exists();
        assertThat(folder.resolve("paper-unfinished.csv")).exists();
    }

    @Test
    void writesNothingBeforeTheFirstNumberNorAfterTheEnd() {
        KeptNumbers kept = new KeptNumbers(folder);

        assertThat(kept.end()).isEqualTo("nothing was measured");
        kept.keep(REPORT);

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whatCannotBeWrittenIsSaidAtTheEndOnly() throws IOException {
        Path gone = Files.createDirectory(folder.resolve("gone"));
        KeptNumbers kept = new KeptNumbers(gone);
        Files.delete(gone);
        kept.keep(REPORT);

        assertThat(kept.end()).contains("lost", "there is no folder");
    }
}
