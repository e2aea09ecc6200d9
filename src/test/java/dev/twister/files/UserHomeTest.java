package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UserHomeTest {
    @ParameterizedTest
    @ValueSource(strings = {"Linux", "Mac OS X", "FreeBSD"})
    void onUnixTheVariableWins(String system) {
        assertThat(UserFolder.UserHome.find(system, Map.of("HOME", "/mine"), "/home/ada"))
                .isEqualTo("/mine");
    }

    @ParameterizedTest
    @ValueSource(strings = {"Linux", "Mac OS X"})
    void withoutTheVariableJavaSays(String system) {
        assertThat(UserFolder.UserHome.find(system, Map.of(), "/home/ada")).isEqualTo("/home/ada");
        assertThat(UserFolder.UserHome.find(system, Map.of("HOME", ""), "/home/ada"))
                .isEqualTo("/home/ada");
    }

    @ParameterizedTest
    @ValueSource(strings = {"Windows 11", "Windows Server 2025"})
    void onWindowsJavaSays(String system) {
        assertThat(UserFolder.UserHome.find(system, Map.of("HOME", "/mine"), "C:\\Users\\ada"))
                .isEqualTo("C:\\Users\\ada");
    }
}
