package dev.twister.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
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

        assertThat(obstacle(file)).startsWith(file + " ended its process (exit code ");
    }

    @Test
    void saysThatALibraryDoesNotAnswer() throws IOException, InterruptedException {
        Path file = compiled("unsigned sleep(unsigned);"
                + " __attribute__((constructor)) static void hang() { for (;;) sleep(1); }");

        assertThat(failure(file, 3)).isEqualTo("did not answer within 3 s");
    }

    @Test
    void endsTheProcessesThatALibraryStarts() throws IOException, InterruptedException {
        Path file = compiled("int fork(void); void abort(void); unsigned sleep(unsigned);"
                + " __attribute__((constructor)) static void hang() { if (fork() == 0) for (;;) sleep(1); abort(); }");

        assertThat(failure(file, 20)).startsWith("ended its process (exit code ");
        assertThat(ProcessHandle.allProcesses().filter(other -> isOf(file, other)))
                .allSatisfy(left -> left.onExit().get(10, TimeUnit.SECONDS));
    }

    @Test
    void survivesALibraryThatPrintsWithoutEnd() throws IOException, InterruptedException {
        Path file = compiled("int puts(const char*); __attribute__((constructor)) static void flood()"
                + " { for (;;) puts(\"works: 2.0\"); }");

        assertThat(failure(file, 2)).isEqualTo("did not answer within 2 s");
    }

    /** Functions of a library that denoises the first picture, which is the one that it is tried with. */
    private static final String WORKS_ONCE = """
            void* oidnNewDevice(int type) { return (void*) 1; }
            void oidnCommitDevice(void* device) {}
            int oidnGetDeviceInt(void* device, const char* name) { return name[0] == 'v' ? 20000 : 1; }
            int oidnGetDeviceError(void* device, const char** text) { return 0; }
            void oidnReleaseDevice(void* device) {}
            static char memory[1 << 20];
            void* oidnNewBufferWithStorage(void* device, unsigned long bytes, int storage) { return memory; }
            void* oidnGetBufferData(void* buffer) { return buffer; }
            void oidnReleaseBuffer(void* buffer) {}
            void* oidnNewFilter(void* device, const char* type) { return (void*) 1; }
            void oidnSetFilterImage() {}
            void oidnSetFilterBool() {}
            void oidnSetFilterInt() {}
            void oidnSetFilterFloat() {}
            void oidnCommitFilter(void* filter) {}
            void oidnReleaseFilter(void* filter) {}
            void abort(void);
            int fork(void);
            unsigned sleep(unsigned);
            static int pictures = 0;
            void oidnExecuteFilter(void* filter) { if (++pictures > 1) { LATER } }
            """;

    @Test
    void survivesALibraryThatCrashesLater() throws IOException, InterruptedException {
        Path file = compiled(WORKS_ONCE.replace("LATER", "if (fork() == 0) for (;;) sleep(1); abort();"));

        try (Denoiser denoiser = new OpenImageDenoise(file.toString())) {
            for (int time = 0; time < 2; time++) {
                assertThatExceptionOfType(DenoiseException.class)
                        .isThrownBy(() -> denoiser.denoise(picture()))
                        .withMessageStartingWith(file + " ended its process (exit code ");
            }
        }
        assertThat(ProcessHandle.allProcesses().filter(other -> isOf(file, other)))
                .allSatisfy(left -> left.onExit().get(10, TimeUnit.SECONDS));
    }

    @Test
    void saysThatALibraryHangsLater() throws IOException, InterruptedException {
        Path file = compiled(WORKS_ONCE.replace("LATER", "for (;;) sleep(1);"));

        try (Denoiser denoiser = new OpenImageDenoise(file.toString(), 3, Bands.MOST_PIXELS)) {
            assertThatExceptionOfType(DenoiseException.class)
                    .isThrownBy(() -> denoiser.denoise(picture()))
                    .withMessage(file + " did not answer within 3 s");
        }
    }

    @Test
    void stopsWhenTheThreadIsInterrupted() throws IOException, InterruptedException {
        Path file = compiled(WORKS_ONCE.replace("LATER", "for (;;) sleep(1);"));

        try (Denoiser denoiser = new OpenImageDenoise(file.toString())) {
            Thread.currentThread().interrupt();
            assertThatExceptionOfType(DenoiseException.class)
                    .isThrownBy(() -> denoiser.denoise(picture()))
                    .withMessage(file + " was stopped");
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    private static NoisyPicture picture() {
        return new NoisyPicture(8, 8, new Plane(new float[3 * 8 * 8], 0), Optional.empty());
    }

    private static String failure(Path library, long mostSeconds) {
        try (OpenImageDenoise opened = new OpenImageDenoise(library.toString(), mostSeconds, Bands.MOST_PIXELS)) {
            return opened.text();
        } catch (DenoiseException problem) {
            return problem.getMessage();
        }
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
