package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class InputFileTest {
    @TempDir
    private Path folder;

    @Test
    void filesAndLinksToThemHaveNoProblem() throws IOException {
        Path file = Files.createFile(folder.resolve("a"));
        Path link = Files.createSymbolicLink(folder.resolve("link"), file);

        assertThat(InputFile.problem(file)).isEmpty();
        assertThat(InputFile.problem(link)).isEmpty();
    }

    @Test
    void namesWhatIsNoFile() {
        assertThat(InputFile.problem(folder)).contains("is a folder, but must be a file");
        assertThat(InputFile.problem(folder.resolve("missing"))).contains("file not found");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void namesFifosDevicesAndSocketsWithoutOpeningThem() throws IOException, InterruptedException {
        Path fifo = folder.resolve("fifo");
        assertThat(new ProcessBuilder("mkfifo", fifo.toString()).start().waitFor())
                .isZero();
        Path socket = folder.resolve("s");
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(socket));

            assertThat(InputFile.problem(fifo)).contains("is a FIFO, but must be a file");
            assertThat(InputFile.problem(Path.of("/dev/null"))).contains("is a device, but must be a file");
            assertThat(InputFile.problem(socket)).contains("is a socket, but must be a file");
        }
    }

    @Test
    void openingTellsTheFileAndTheProblem() {
        assertThatThrownBy(() -> InputFile.open(folder))
                .isInstanceOf(IOException.class)
                .hasMessage(folder + ": is a folder, but must be a file");
    }
}
