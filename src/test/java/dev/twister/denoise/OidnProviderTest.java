package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Libraries that do not work. */
class OidnProviderTest {
    private static final String ADVICE = "; install Open Image Denoise by 'pip install pyoidn' or from"
            + " https://www.openimagedenoise.org, or let TWISTER_OIDN name its library or folder";

    @TempDir
    private Path folder;

    @Test
    void saysThatTheVariableLeadsNowhere() {
        Path missing = folder.resolve("missing");

        assertThat(obstacle(missing))
                .isEqualTo("TWISTER_OIDN is " + missing + ", but there is no Open Image Denoise" + ADVICE);
    }

    @Test
    void refusesAFileThatIsNoLibrary() throws IOException {
        Path file = Files.writeString(folder.resolve("library.so"), "text");

        assertThat(obstacle(file))
                .isEqualTo(file + " cannot be loaded; it is damaged, or for another system or processor" + ADVICE);
    }

    @Test
    void refusesAnotherLibrary() throws IOException, InterruptedException {
        Path file = compiled("int something() { return 1; }");

        assertThat(obstacle(file))
                .isEqualTo(file + " is not Open Image Denoise: it has no function oidnNewDevice" + ADVICE);
    }

    @Test
    void refusesAnOldVersion() throws IOException, InterruptedException {
        Path file = compiled("void* oidnNewDevice(int type) { return 0; }");

        assertThat(obstacle(file))
                .isEqualTo(file + " is Open Image Denoise 1; version 2.0 or newer is needed" + ADVICE);
    }

    @Test
    void survivesALibraryThatCrashesOnLoad() throws IOException, InterruptedException {
        Path file = compiled("__attribute__((constructor)) static void crash() { *(volatile int*) 8 = 1; }");

        assertThat(obstacle(file)).startsWith(file + " ended the process that tried it (exit code ");
    }

    @Test
    void saysThatALibraryDoesNotAnswer() throws IOException, InterruptedException {
        Path file = compiled("unsigned sleep(unsigned);"
                + " __attribute__((constructor)) static void hang() { for (;;) sleep(1); }");

        assertThat(LibraryProbe.of(file.toString(), 3).obstacle())
                .contains("did not denoise a small picture within 3 s");
    }

    @Test
    void endsTheProcessesThatALibraryStarts() throws IOException, InterruptedException {
        Path file = compiled("int fork(void); void abort(void); unsigned sleep(unsigned);"
                + " __attribute__((constructor)) static void hang() { if (fork() == 0) for (;;) sleep(1); abort(); }");

        assertThat(LibraryProbe.of(file.toString(), 20).obstacle().orElseThrow())
                .startsWith("ended the process that tried it (exit code ");
        assertThat(ProcessHandle.allProcesses().filter(other -> isOf(file, other)))
                .allSatisfy(left -> left.onExit().get(10, TimeUnit.SECONDS));
    }

    @Test
    void survivesALibraryThatPrintsWithoutEnd() throws IOException, InterruptedException {
        Path file = compiled("int puts(const char*); __attribute__((constructor)) static void flood()"
                + " { for (;;) puts(\"works: 2.0\"); }");

        assertThat(LibraryProbe.of(file.toString(), 2).obstacle())
                .contains("did not denoise a small picture within 2 s");
    }

    private static boolean isOf(Path library, ProcessHandle process) {
        return process.info()
                .commandLine()
                .filter(line -> line.contains(library.toString()))
                .isPresent();
    }

    @Test
    void openingWhatDoesNotWorkTellsWhy() {
        DenoiserOffer offer = DenoiserOffer.impossible("library", "it is too old");

        assertThatExceptionOfType(DenoiseException.class)
                .isThrownBy(offer.opener()::get)
                .withMessage("it is too old");
    }

    private String obstacle(Path library) {
        Map<String, String> environment = Map.of(LibraryPlaces.VARIABLE, library.toString());
        return OidnProvider.offer(new LibraryPlaces(environment, folder, "Linux"))
                .obstacle()
                .orElseThrow();
    }

    private Path compiled(String code) throws IOException, InterruptedException {
        Path source = Files.writeString(folder.resolve("library.c"), code);
        Path library = folder.resolve("library.so");
        try {
            Process compiler = new ProcessBuilder("cc", "-shared", "-fPIC", "-o", library.toString(), source.toString())
                    .redirectErrorStream(true)
                    .start();
            compiler.getInputStream().transferTo(OutputStream.nullOutputStream());
            if (!compiler.waitFor(1, TimeUnit.MINUTES) || compiler.exitValue() != 0) {
                abort("cc does not compile a library here");
            }
        } catch (IOException _) {
            abort("there is no C compiler (cc) here");
        }
        return library;
    }
}
