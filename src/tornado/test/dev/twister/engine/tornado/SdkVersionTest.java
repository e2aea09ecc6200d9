package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SdkVersionTest {
    @TempDir
    private Path sdk;

    @ParameterizedTest
    @ValueSource(strings = {"5.3.0-jdk25", "6.0.1-dev", "7.0.0", "10.0"})
    void newerVersionsGiveAWarning(String version) throws IOException {
        release("version=" + version + "\nbranch=main\ncommit=1234567\n");

        assertThat(SdkVersion.of(sdk).flatMap(SdkVersion::warning).orElseThrow())
                .startsWith("TornadoVM " + version + " has not been tested; the newest tested version is 5.2.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"5.2.1-jdk25-dev", "5.2.0", "4.9.9", "5.1.10"})
    void testedAndOlderVersionsGiveNone(String version) throws IOException {
        release("version=" + version + "\n");

        assertThat(SdkVersion.of(sdk)).isPresent();
        assertThat(SdkVersion.of(sdk).flatMap(SdkVersion::warning)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "branch=main\n", "version=\n", "version=next\n", "version=99999999999.0\n"})
    void unknownVersionsAreEmpty(String text) throws IOException {
        release(text);

        assertThat(SdkVersion.of(sdk)).isEmpty();
    }

    @Test
    void missingFilesAreEmpty() {
        assertThat(SdkVersion.of(sdk)).isEmpty();
    }

    private void release(String text) throws IOException {
        Files.writeString(Files.createDirectories(sdk.resolve("etc")).resolve("tornado.release"), text);
    }
}
