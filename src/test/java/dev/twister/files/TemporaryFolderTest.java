package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TemporaryFolderTest {
    @TempDir
    private Path parent;

    @Test
    void isDeletedWithItsContentWhenItIsClosed() throws IOException {
        try (TemporaryFolder folder = TemporaryFolder.create(parent)) {
            Files.createDirectory(folder.path().resolve("inner"));
            Files.writeString(folder.path().resolve("inner/file"), "x");
        }
        assertThat(parent).isEmptyDirectory();
    }

    @Test
    void isDeletedWhenTheProcessIsTerminated() throws IOException, InterruptedException {
        Process java = start();
        Assumptions.assumeTrue(java.supportsNormalTermination(), "this system ends processes without a word to them");
        java.destroy();
        java.waitFor();

        assertThat(parent).isEmptyDirectory();
    }

    @Test
    void whatAKilledProcessLeftIsDeletedByTheNextOne() throws IOException, InterruptedException {
        Process java = start();
        java.destroyForcibly().waitFor();
        assertThat(parent).isNotEmptyDirectory();
        makeOld();

        TemporaryFolder.create(parent).close();

        assertThat(parent).isEmptyDirectory();
    }

    @Test
    void whatALivingProcessHasStays() throws IOException, InterruptedException {
        Process java = start();
        try {
            makeOld();

            TemporaryFolder.create(parent).close();

            assertThat(parent).isNotEmptyDirectory();
        } finally {
            java.destroyForcibly().waitFor();
        }
    }

    @Test
    void aLinkIsNotFollowed() throws IOException {
        Path other = Files.createDirectory(parent.resolve("other"));
        Files.writeString(other.resolve("file"), "x");
        Files.createSymbolicLink(parent.resolve("twister-temporary-1-link"), other);

        TemporaryFolder.create(parent).close();

        assertThat(other.resolve("file")).exists();
    }

    private Process start() throws IOException {
        Process java = ChildJvm.start(
                ChildJvm.of(EndlessMain.class, parent.toString()).redirectError(ProcessBuilder.Redirect.INHERIT));
        BufferedReader output = java.inputReader(StandardCharsets.UTF_8);
        assertThat(output.readLine()).isEqualTo("created");
        return java;
    }

    private void makeOld() throws IOException {
        for (String name : parent.toFile().list()) {
            Files.setLastModifiedTime(parent.resolve(name), FileTime.from(Instant.EPOCH));
        }
    }

    /** Creates a folder with a file, and waits without end. */
    static final class EndlessMain {
        private EndlessMain() {}

        public static void main(String[] arguments) throws IOException {
            try (TemporaryFolder folder = TemporaryFolder.create(Path.of(arguments[0]))) {
                Files.writeString(folder.path().resolve("file"), "x");
                System.out.println("created");
                while (true) {
                    LockSupport.park();
                }
            }
        }
    }
}
