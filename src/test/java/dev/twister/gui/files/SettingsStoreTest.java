package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SettingsStoreTest {
    @TempDir
    private Path home;

    private SettingsStore store() {
        return new SettingsStore(Optional.of(home.resolve("new").resolve("twister")));
    }

    private Path put(String text) throws IOException {
        Path folder = Files.createDirectories(home.resolve("new").resolve("twister"));
        return Files.writeString(folder.resolve(SettingsStore.FILE), text);
    }

    @Test
    void whatIsWrittenIsReadBack() throws IOException {
        WindowSettings settings = WindowSettings.DEFAULT
                .withSize(900, 700)
                .with(WindowSettings.MAXIMIZED, true)
                .with(WindowSettings.PANEL_SHOWN, false)
                .with(WindowSettings.ENGINE, "vector")
                .withRecentScene("/a/b \u00e9.json")
                .withRecentScene("/c.json")
                .with(WindowSettings.HINT_SEEN, true);
        store().write(settings);
        assertThat(store().read()).isEqualTo(new SettingsStore.Found(settings, Optional.empty()));
    }

    @Test
    void thereNeedNotBeAny() {
        assertThat(store().read()).isEqualTo(new SettingsStore.Found(WindowSettings.DEFAULT, Optional.empty()));
    }

    @Test
    void withoutAPlaceNothingIsKept() throws IOException {
        SettingsStore nowhere = new SettingsStore(Optional.empty());
        nowhere.write(WindowSettings.DEFAULT.with(WindowSettings.ENGINE, "vector"));
        assertThat(nowhere.read().settings()).isEqualTo(WindowSettings.DEFAULT);
    }

    @Test
    void whatAFileDoesNotSayIsAsUsualAndWhatIsUnknownIsLeftAlone() throws IOException {
        put("{\"engine\": \"vector\", \"ofTheFuture\": [1, {}]}");
        assertThat(store().read())
                .isEqualTo(new SettingsStore.Found(
                        WindowSettings.DEFAULT.with(WindowSettings.ENGINE, "vector"), Optional.empty()));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "[]",
                "7",
                "{\"width\": ",
                "{\"width\": 3}",
                "{\"width\": 1e99}",
                "{\"engine\": null}",
                "{\"recentScenes\": null}",
                "{\"recentScenes\": [null]}",
                "{\"recentScenes\": \"x\"}",
                "{\"folded\": [null]}",
                "\u0000\u0001\u0002"
            })
    void aDamagedFileIsSetAside(String text) throws IOException {
        Path file = put(text);
        SettingsStore.Found found = store().read();
        assertThat(found.settings()).isEqualTo(WindowSettings.DEFAULT);
        Path aside = file.resolveSibling(SettingsStore.DAMAGED_FILE);
        assertThat(found.message()).get().asString().contains(aside.toString());
        assertThat(aside).hasContent(text);
        assertThat(file).doesNotExist();
        store().write(WindowSettings.DEFAULT);
        assertThat(store().read().message()).isEmpty();
    }

    @Test
    void aPipeInTheFilesPlaceIsSetAside() throws IOException, InterruptedException {
        Path file = put("");
        Files.delete(file);
        assumeThat(new ProcessBuilder("mkfifo", file.toString()).start().waitFor())
                .isZero();
        assertThat(store().read().message()).isPresent();
        assertThat(file).doesNotExist();
    }

    @Test
    void aHugeFileIsNotRead() throws IOException {
        put(" ".repeat(1 << 23));
        assertThat(store().read().message()).isPresent();
    }

    @Test
    void settingsAreReadWholeWhileOthersWriteThem() throws IOException {
        SettingsStore store = store();
        store.write(WindowSettings.DEFAULT);
        List<SettingsStore.Found> found = IntStream.range(0, 100)
                .parallel()
                .mapToObj(_ -> writeAndRead(store))
                .toList();

        assertThat(found).allMatch(read -> read.message().isEmpty());
    }

    private static SettingsStore.Found writeAndRead(SettingsStore store) {
        try {
            store.write(WindowSettings.DEFAULT);
            return store.read();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    @Test
    void recentScenesAreFewAndTheNewestIsFirst() {
        WindowSettings settings = WindowSettings.DEFAULT;
        for (int i = 0; i < 15; i++) {
            settings = settings.withRecentScene("/" + i);
        }
        settings = settings.withRecentScene("/10");
        assertThat(settings.get(WindowSettings.RECENT_SCENES))
                .containsExactly("/10", "/14", "/13", "/12", "/11", "/9", "/8", "/7", "/6", "/5");
        assertThat(settings.withoutRecentScene("/10").get(WindowSettings.RECENT_SCENES))
                .hasSize(9)
                .doesNotContain("/10");
    }

    @Test
    void aWindowOfNoSizeIsKeptUsable() {
        WindowSettings settings = WindowSettings.DEFAULT.withSize(0, 100_000);
        assertThat(settings.get(WindowSettings.WIDTH)).isEqualTo(WindowSettings.MIN_SIDE);
        assertThat(settings.get(WindowSettings.HEIGHT)).isEqualTo(WindowSettings.MAX_SIDE);
    }
}
