package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the paths here are absolute elsewhere only")
class UserFolderTest {
    @Test
    void linuxHasTheXdgFolderOrTheHomes() {
        assertThat(UserFolder.CACHE.find("Linux", "/home/ada", Map.of())).contains(Path.of("/home/ada/.cache/twister"));
        assertThat(UserFolder.CACHE.find("Linux", "/home/ada", Map.of("XDG_CACHE_HOME", "/fast")))
                .contains(Path.of("/fast/twister"));
        assertThat(UserFolder.CACHE.find("Linux", "/home/ada", Map.of("XDG_CACHE_HOME", "relative")))
                .contains(Path.of("/home/ada/.cache/twister"));
    }

    @Test
    void macHasItsLibrary() {
        assertThat(UserFolder.CACHE.find("Mac OS X", "/Users/ada", Map.of("XDG_CACHE_HOME", "/fast")))
                .contains(Path.of("/Users/ada/Library/Caches/twister"));
    }

    @Test
    void windowsHasTheLocalFolder() {
        assertThat(UserFolder.CACHE.find("Windows 11", "/users/ada", Map.of("LOCALAPPDATA", "/users/ada/local")))
                .contains(Path.of("/users/ada/local/twister"));
        assertThat(UserFolder.CACHE.find("Windows 11", "/users/ada", Map.of())).isEmpty();
    }

    @Test
    void settingsHaveAPlaceOfTheirOwn() {
        UserFolder settings = UserFolder.SETTINGS;
        assertThat(settings.find("Linux", "/home/ada", Map.of())).contains(Path.of("/home/ada/.config/twister"));
        assertThat(settings.find("Linux", "/home/ada", Map.of("XDG_CONFIG_HOME", "/mine")))
                .contains(Path.of("/mine/twister"));
        assertThat(settings.find("Mac OS X", "/Users/ada", Map.of()))
                .contains(Path.of("/Users/ada/Library/Application Support/twister"));
        assertThat(settings.find("Windows 11", "/users/ada", Map.of("APPDATA", "/users/ada/roaming")))
                .contains(Path.of("/users/ada/roaming/twister"));
    }

    @Test
    void stateHasAPlaceOfItsOwn() {
        UserFolder state = UserFolder.STATE;
        assertThat(state.find("Linux", "/home/ada", Map.of())).contains(Path.of("/home/ada/.local/state/twister"));
        assertThat(state.find("Linux", "/home/ada", Map.of("XDG_STATE_HOME", "/mine")))
                .contains(Path.of("/mine/twister"));
        assertThat(state.find("Mac OS X", "/Users/ada", Map.of()))
                .contains(Path.of("/Users/ada/Library/Application Support/twister"));
        assertThat(state.find("Windows 11", "/users/ada", Map.of("LOCALAPPDATA", "/users/ada/local")))
                .contains(Path.of("/users/ada/local/twister"));
    }

    @Test
    void thereMayBeNone() {
        assertThat(UserFolder.CACHE.find("Linux", "", Map.of())).isEmpty();
        assertThat(UserFolder.CACHE.find("Linux", "?", Map.of())).isEmpty();
    }
}
