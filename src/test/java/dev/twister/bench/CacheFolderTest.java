package dev.twister.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the paths here are absolute elsewhere only")
class CacheFolderTest {
    @Test
    void linuxHasTheXdgFolderOrTheHomes() {
        assertThat(CacheFolder.find("Linux", "/home/ada", Map.of())).contains(Path.of("/home/ada/.cache/twister"));
        assertThat(CacheFolder.find("Linux", "/home/ada", Map.of("XDG_CACHE_HOME", "/fast")))
                .contains(Path.of("/fast/twister"));
        assertThat(CacheFolder.find("Linux", "/home/ada", Map.of("XDG_CACHE_HOME", "relative")))
                .contains(Path.of("/home/ada/.cache/twister"));
    }

    @Test
    void macHasItsLibrary() {
        assertThat(CacheFolder.find("Mac OS X", "/Users/ada", Map.of("XDG_CACHE_HOME", "/fast")))
                .contains(Path.of("/Users/ada/Library/Caches/twister"));
    }

    @Test
    void windowsHasTheLocalFolder() {
        assertThat(CacheFolder.find("Windows 11", "/users/ada", Map.of("LOCALAPPDATA", "/users/ada/local")))
                .contains(Path.of("/users/ada/local/twister"));
        assertThat(CacheFolder.find("Windows 11", "/users/ada", Map.of())).isEmpty();
    }

    @Test
    void thereMayBeNone() {
        assertThat(CacheFolder.find("Linux", "", Map.of())).isEmpty();
        assertThat(CacheFolder.find("Linux", "?", Map.of())).isEmpty();
    }
}
