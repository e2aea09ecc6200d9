package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LibraryPlacesTest {
    private static final String LINUX = "Linux";
    private static final String FILE = "libOpenImageDenoise.so.2";

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"", "lib", "lib/" + FILE})
    void theVariableNamesTheLibraryOrAFolder(String named) throws IOException {
        Path library = library("lib");

        assertThat(places(Map.of(LibraryPlaces.VARIABLE, folder.resolve(named).toString()), LINUX)
                        .files())
                .containsExactly(library);
    }

    @Test
    void nothingElseIsTriedIfTheVariableIsSet() throws IOException {
        library("oidn/lib");
        Map<String, String> environment =
                Map.of(LibraryPlaces.VARIABLE, folder.resolve("missing").toString(), "TWISTER_HOME", folder.toString());

        assertThat(places(environment, LINUX).files()).isEmpty();
    }

    @Test
    void thePackagesOwnFolderComesBeforeTheLibraryPath() throws IOException {
        Path own = library("oidn/lib");
        Path onPath = library("path");
        Map<String, String> environment = Map.of(
                "TWISTER_HOME", folder.toString(), "LD_LIBRARY_PATH", folder.resolve("path") + File.pathSeparator);

        assertThat(places(environment, LINUX).files()).startsWith(own, onPath);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                ".local/lib/python3.12/site-packages/pyoidn/oidn/lib",
                "env/lib/python3.9/site-packages/pyoidn/oidn/lib",
                "usr/lib/python3.13/dist-packages/pyoidn/oidn/lib"
            })
    void pipsPlacesAreKnown(String place) throws IOException {
        Path library = library(place);
        Map<String, String> environment = Map.of(
                "VIRTUAL_ENV", folder.resolve("env").toString(),
                "PATH", folder.resolve("usr/bin").toString());

        assertThat(places(environment, LINUX).files()).contains(library);
    }

    /** Windows would look in the current folder, beside a scene of someone else. */
    @Test
    void onWindowsOnlyAbsolutePlacesAreTried() {
        assertThat(places(Map.of(), "Windows 11").names()).isEmpty();
        assertThat(places(Map.of(), LINUX).names()).isNotEmpty();
    }

    @Test
    void placesThatDependOnTheCurrentFolderAreNotTried() throws IOException {
        Path here = Path.of("").toAbsolutePath();
        library("oidn/lib");
        Map<String, String> environment =
                Map.of("TWISTER_HOME", here.relativize(folder.toAbsolutePath()).toString(), "LD_LIBRARY_PATH", ".");

        assertThat(places(environment, LINUX).files()).noneMatch(file -> file.startsWith(folder));
    }

    @Test
    void aPathThatCannotBeIsIgnored() {
        assertThat(places(Map.of(LibraryPlaces.VARIABLE, "\0"), LINUX).files()).isEmpty();
    }

    private LibraryPlaces places(Map<String, String> environment, String system) {
        return new LibraryPlaces(environment, folder, system);
    }

    private Path library(String place) throws IOException {
        Path file = Files.createDirectories(folder.resolve(place)).resolve(FILE);
        return Files.write(file, new byte[1]);
    }
}
