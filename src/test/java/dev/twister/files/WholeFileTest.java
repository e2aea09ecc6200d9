package dev.twister.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.ChildJvm;
import dev.twister.Links;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
    @TempDir
    Path folder;

    @Test
    void writesAndReplaces() throws IOException {
        Path file = folder.resolve("report.json");
        WholeFile.write(file, out -> out.write(ascii("first, and longer")));
        WholeFile.write(file, out -> out.write(ascii("second")));
        assertThat(file).hasContent("second");
        assertThat(names()).containsExactly("report.json");
    }

    @Test
    void aFailureOfTheDiskLeavesTheOldFileAndNoOther() throws IOException {
        Path file = Files.writeString(folder.resolve("old.txt"), "old");
        assertThatThrownBy(() -> WholeFile.write(file, out -> {
                    out.write(ascii("half of"));
                    throw new IOException("No space left on device");
                }))
                .isInstanceOf(IOException.class)
                .hasMessage("cannot write " + file + ": disk full");
        assertThat(file).hasContent("old");
        assertThat(names()).containsExactly("old.txt");
    }

    @Test
    void aFailureOfTheProgramLeavesNothing() throws IOException {
        assertThatThrownBy(() -> WholeFile.write(folder.resolve("new.txt"), out -> {
                    throw new IllegalStateException("a bug");
                }))
                .isInstanceOf(IllegalStateException.class);
        assertThat(names()).isEmpty();
    }

    @Test
    void theEndOfTheProcessLeavesNothingButWhatIsWrittenBecauseOfIt() throws IOException, InterruptedException {
        Process java = ChildJvm.start(
                ChildJvm.of(SlowMain.class, folder.toString()).redirectError(ProcessBuilder.Redirect.INHERIT));
        Assumptions.assumeTrue(java.supportsNormalTermination(), "this system ends processes without a word to them");
        try (BufferedReader output = java.inputReader(StandardCharsets.UTF_8)) {
            assertThat(output.readLine()).isEqualTo("writing");
            assertThat(names()).hasSize(1).allMatch(name -> name.endsWith(".tmp"));
        } finally {
            java.destroy();
        }
        java.waitFor();
        assertThat(names()).containsExactly("unfinished.json");
    }

    /** Writes a file endlessly, and writes another one in its shutdown hook. */
    static final class SlowMain {
        private SlowMain() {}

        public static void main(String[] arguments) throws IOException {
            Path folder = Path.of(arguments[0]);
            Runtime.getRuntime().addShutdownHook(new Thread(() -> LastWrites.run(() -> writeUnfinished(folder))));
            WholeFile.write(folder.resolve("picture.png"), out -> {
                out.write(1);
                System.out.println("writing");
                while (true) {
                    LockSupport.park();
                }
            });
        }

        private static void writeUnfinished(Path folder) {
            try {
                WholeFile.write(folder.resolve("unfinished.json"), out -> out.write(1));
            } catch (IOException problem) {
                throw new UncheckedIOException(problem);
            }
        }
    }

    @Test
    void noFileIsBegunWhileTheProcessEnds() throws IOException, InterruptedException {
        Process java = ChildJvm.start(
                ChildJvm.of(LateMain.class, folder.toString()).redirectError(ProcessBuilder.Redirect.INHERIT));
        try (BufferedReader output = java.inputReader(StandardCharsets.UTF_8)) {
            assertThat(output.readLine())
                    .isEqualTo("cannot write " + folder.resolve("late.png") + ": the process is ending");
        }
        java.waitFor();
        assertThat(names()).isEmpty();
    }

    /** Begins a file after shutdown has started. */
    static final class LateMain {
        private LateMain() {}

        public static void main(String[] arguments) {
            Path folder = Path.of(arguments[0]);
            Runtime.getRuntime().addShutdownHook(new Thread(() -> write(folder.resolve("late.png"))));
        }

        private static void write(Path file) {
            try {
                WholeFile.write(file, out -> out.write(1));
            } catch (IOException problem) {
                System.out.println(problem.getMessage());
            }
        }
    }

    @Test
    void readersSeeAWholeVersionWhileProcessesReplaceIt() throws IOException, InterruptedException {
        Path file = Files.writeString(folder.resolve("window.json"), "a".repeat(ReplacingMain.LENGTH));
        List<Process> processes = new ArrayList<>();
        for (String letter : List.of("b", "c", "d")) {
            processes.add(ChildJvm.start(
                    ChildJvm.of(ReplacingMain.class, file.toString(), letter).inheritIO()));
        }
        while (processes.stream().anyMatch(Process::isAlive)) {
            assertThat(Files.readString(file)).hasSize(ReplacingMain.LENGTH).matches("(.)\\1*");
        }

        assertThat(processes).allMatch(process -> process.exitValue() == 0);
        assertThat(names()).containsExactly("window.json");
    }

    /** Replaces a file many times by versions of one letter, as processes do that share a folder. */
    static final class ReplacingMain {
        static final int LENGTH = 100_000;

        private ReplacingMain() {}

        public static void main(String[] arguments) throws IOException {
            Path file = Path.of(arguments[0]);
            byte[] version = arguments[1].repeat(LENGTH).getBytes(StandardCharsets.UTF_8);
            for (int i = 0; i < 50; i++) {
                WholeFile.deleteLeftovers(file.getParent());
                WholeFile.write(file, out -> out.write(version));
            }
        }
    }

    @Test
    void whatIsReplacedKeepsItsPermissions() throws IOException {
        Assumptions.assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        for (String permissions : List.of("rw-------", "rw-rw-rw-", "rwxr-x---")) {
            Path file = Files.writeString(folder.resolve("mine.png"), "old");
            Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
            WholeFile.write(file, out -> out.write(1));
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                    .isEqualTo(permissions);
        }
    }

    @Test
    void saysThatTheFolderIsMissing() {
        Path missing = folder.resolve("no such folder");
        assertThatThrownBy(() -> WholeFile.write(missing.resolve("x.png"), out -> out.write(1)))
                .isInstanceOf(IOException.class)
                .hasMessage("cannot write " + missing.resolve("x.png") + ": there is no folder " + missing);
    }

    @Test
    void saysWhatTheSystemHasAgainstANameAndNotItsOwnTemporaryOne() {
        Path file = folder.resolve("a".repeat(300));
        assertThatThrownBy(() -> WholeFile.write(file, out -> out.write(1)))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("cannot write " + file + ": ")
                .message()
                .doesNotContain(".tmp")
                .hasSizeGreaterThan(("cannot write " + file + ": ").length());
    }

    @Test
    void saysThatAFolderTakesNoFiles() {
        Path file = Path.of("/proc/x.png");
        Assumptions.assumeTrue(Files.isDirectory(file.getParent()));
        assertThatThrownBy(() -> WholeFile.write(file, out -> out.write(1)))
                .isInstanceOf(IOException.class)
                .hasMessage("cannot write " + file + ": no file can be made there");
    }

    @Test
    void saysThatTheTargetIsAFolder() {
        assertThatThrownBy(() -> WholeFile.write(folder, out -> out.write(1)))
                .isInstanceOf(IOException.class)
                .hasMessage("cannot write " + folder + ": it is a folder");
    }

    @Test
    void saysThatThePermissionIsMissing() throws IOException {
        Assumptions.assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("r-xr-xr-x"));
        try {
            Assumptions.assumeFalse(Files.isWritable(folder), "root may write anywhere");
            assertThatThrownBy(() -> WholeFile.write(folder.resolve("x.png"), out -> out.write(1)))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("no permission in the folder");
        } finally {
            Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
        }
    }

    @Test
    void saysThatThePermissionIsMissingBehindALink() throws IOException {
        Assumptions.assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Path closed = Files.createDirectory(folder.resolve("closed"));
        Path link = Links.make(folder.resolve("link.txt"), closed.resolve("x.txt"));
        Files.setPosixFilePermissions(closed, PosixFilePermissions.fromString("r-xr-xr-x"));
        try {
            Assumptions.assumeFalse(Files.isWritable(closed), "root may write anywhere");
            assertThatThrownBy(() -> WholeFile.write(link, out -> out.write(1)))
                    .isInstanceOf(IOException.class)
                    .hasMessage("cannot write " + link + ": no permission in the folder " + closed);
        } finally {
            Files.setPosixFilePermissions(closed, PosixFilePermissions.fromString("rwxr-xr-x"));
        }
    }

    @Test
    void followsLinks() throws IOException {
        Path file = Files.writeString(folder.resolve("real.txt"), "old");
        Links.make(folder.resolve("link.txt"), file);
        Path link = Links.make(folder.resolve("link of a link.txt"), Path.of("link.txt"));
        WholeFile.write(link, out -> out.write(ascii("new")));
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("new");
    }

    @Test
    void makesTheFileThatALinkLeadsTo() throws IOException {
        Path link = Links.make(folder.resolve("link.txt"), folder.resolve("not yet.txt"));
        WholeFile.write(link, out -> out.write(ascii("new")));
        assertThat(link).isSymbolicLink();
        assertThat(folder.resolve("not yet.txt")).hasContent("new");
    }

    @Test
    void refusesLinksThatLeadToOneAnother() throws IOException {
        Path one = Links.make(folder.resolve("one.txt"), Path.of("other.txt"));
        Links.make(folder.resolve("other.txt"), Path.of("one.txt"));
        assertThatThrownBy(() -> WholeFile.write(one, out -> out.write(1)))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("cannot write " + one)
                .hasMessageEndingWith("its links lead to one another");
    }

    @Test
    void tellsWhichDeviceFailed() {
        Path device = Path.of("/dev/full");
        Assumptions.assumeTrue(Files.exists(device));
        assertThatThrownBy(() -> WholeFile.write(device, out -> out.write(1)))
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("cannot write /dev/full: ");
    }

    @Test
    void writesADeviceWithoutReplacingIt() throws IOException {
        Path device = Path.of("/dev/null");
        Assumptions.assumeTrue(Files.exists(device));
        WholeFile.write(device, out -> out.write(ascii("gone")));
        assertThat(Files.isRegularFile(device)).isFalse();
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).toList();
        }
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
