package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SystemReasonTest {
    static Stream<Arguments> failures() {
        return Stream.of(
                Arguments.of(new NoSuchFileException("/a"), "file not found"),
                Arguments.of(new AccessDeniedException("/a"), "permission denied"),
                Arguments.of(new FileAlreadyExistsException("/a"), "a file of that name already exists"),
                Arguments.of(new FileSystemException("/a", "/b", "File name too long"), "File name too long"),
                Arguments.of(new FileSystemException("/a"), "FileSystemException"),
                Arguments.of(new IOException("No space left on device"), "disk full"),
                Arguments.of(new IOException(), "IOException"));
    }

    @ParameterizedTest
    @MethodSource("failures")
    void namesTheReasonAndNoFile(IOException failure, String reason) {
        assertThat(SystemReason.of(failure)).isEqualTo(reason);
    }
}
