package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TemporaryFileTest {
    @TempDir
    Path folder;

    @Test
    void isNotMadeAfterItWasDeleted() throws IOException {
        try (TemporaryFile temporary = TemporaryFile.of(folder.resolve("a.png"))) {
            temporary.end();
            assertThatThrownBy(temporary::create).isInstanceOf(IOException.class);
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void isNotMissedAfterItWasDeleted() throws IOException {
        try (TemporaryFile temporary = TemporaryFile.of(folder.resolve("a.png"));
                FileChannel channel = temporary.create()) {
            temporary.end();
            channel.force(true);
            assertThatThrownBy(temporary::moveIntoPlace)
                    .isInstanceOf(IOException.class)
                    .hasMessage("the process is ending");
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whatAKilledProcessLeftIsDeleted() throws IOException {
        Path left = old(".twister-1234.tmp");
        Path another = old(".another.tmp");
        Path picture = old("twister-1234.tmp");

        TemporaryFile.deleteLeftovers(folder);

        assertThat(left).doesNotExist();
        assertThat(another).exists();
        assertThat(picture).exists();
    }

    @Test
    void whatIsWrittenStays() throws IOException {
        Path written = old(".twister-1234.tmp");
        Path unlocked = Files.setLastModifiedTime(
                old(".twister-5678.tmp"), FileTime.from(Instant.now().plus(Duration.ofHours(1))));
        try (FileChannel channel = FileChannel.open(written, StandardOpenOption.WRITE)) {
            channel.lock();

            TemporaryFile.deleteLeftovers(folder);

            assertThat(written).exists();
            assertThat(unlocked).exists();
        }
    }

    @Test
    void aFolderThatIsNotThereIsNone() {
        TemporaryFile.deleteLeftovers(folder.resolve("missing"));
        assertThat(folder).isEmptyDirectory();
    }

    private Path old(String name) throws IOException {
        Path file = Files.writeString(folder.resolve(name), "a part");
        return Files.setLastModifiedTime(file, FileTime.from(Instant.EPOCH));
    }
}
