package dev.twister.gui.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.IntBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(300)
class FrameRecorderTest {
    private static final int WIDTH = 4;
    private static final int HEIGHT = 3;

    @TempDir
    private Path folder;

    private static IntBuffer frame(int gray) {
        int[] argb = new int[WIDTH * HEIGHT];
        Arrays.fill(argb, 0xFF000000 | gray << 16 | gray << 8 | gray);
        return IntBuffer.wrap(argb);
    }

    @Test
    void framesAreNumberedAndKeptAsTheyWere() throws IOException {
        FrameRecorder recorder = FrameRecorder.start(folder);
        IntBuffer shared = frame(10);
        recorder.offer(WIDTH, HEIGHT, shared, true);
        // The window draws over its buffer at once.
        shared.put(0, frame(20), 0, WIDTH * HEIGHT);
        recorder.offer(WIDTH, HEIGHT, shared, true);
        recorder.close();
        assertThat(recorder.progress()).isEqualTo(new FrameRecorder.Progress(2, 0, Optional.empty()));
        assertThat(gray("frame-000001.png")).isEqualTo(10);
        assertThat(gray("frame-000002.png")).isEqualTo(20);
    }

    private int gray(String name) throws IOException {
        return ImageIO.read(folder.resolve(name).toFile()).getRGB(WIDTH - 1, HEIGHT - 1) & 255;
    }

    @Test
    void anOlderRecordingIsContinued() throws IOException {
        Files.createFile(folder.resolve("frame-000041.png"));
        Files.createFile(folder.resolve("frame-old.png"));
        FrameRecorder recorder = FrameRecorder.start(folder);
        recorder.offer(WIDTH, HEIGHT, frame(1), true);
        recorder.close();
        assertThat(folder.resolve("frame-000042.png")).exists();
    }

    @Test
    void whoIsFasterThanTheDiskWaitsAndNoFrameIsLost() throws Exception {
        CountDownLatch writing = new CountDownLatch(1);
        CountDownLatch mayWrite = new CountDownLatch(1);
        FrameRecorder recorder = FrameRecorder.start(folder, (file, _, _, _, _) -> {
            writing.countDown();
            await(mayWrite);
            Files.createFile(file);
        });
        int side = 4096;
        Thread source = offering(recorder, side, 6);
        writing.await();
        awaitWaiting(source, recorder);
        assertThat(recorder.progress()).isEqualTo(new FrameRecorder.Progress(0, 4, Optional.empty()));
        mayWrite.countDown();
        source.join();
        recorder.close();
        assertThat(recorder.progress()).isEqualTo(new FrameRecorder.Progress(6, 0, Optional.empty()));
        for (int number = 1; number <= 6; number++) {
            assertThat(folder.resolve("frame-00000" + number + ".png")).exists();
        }
    }

    @Test
    void theEndFreesWhoWaits() throws Exception {
        CountDownLatch mayWrite = new CountDownLatch(1);
        FrameRecorder recorder = FrameRecorder.start(folder, (_, _, _, _, _) -> await(mayWrite));
        Thread source = offering(recorder, 4096, 6);
        awaitWaiting(source, recorder);
        recorder.finish();
        source.join();
        mayWrite.countDown();
        recorder.close();
        assertThat(recorder.progress().written()).isEqualTo(4);
    }

    /** A thread that hands so many frames over. */
    private static Thread offering(FrameRecorder recorder, int side, int frames) {
        IntBuffer large = IntBuffer.allocate(side * side);
        return Thread.ofPlatform().start(() -> {
            for (int i = 0; i < frames; i++) {
                recorder.offer(side, side, large, true);
            }
        });
    }

    /** Until a thread waits because four of its frames, of which none is written, are all that the recorder takes. */
    private static void awaitWaiting(Thread source, FrameRecorder recorder) throws InterruptedException {
        while (recorder.progress().waiting() < 4 || source.getState() != Thread.State.WAITING) {
            Thread.sleep(1);
        }
    }

    private static void await(CountDownLatch latch) throws IOException {
        try {
            latch.await();
        } catch (InterruptedException problem) {
            throw new IOException(problem);
        }
    }

    @Test
    void aFullDiskEndsItAndSaysSo() throws IOException {
        FrameRecorder recorder = FrameRecorder.start(folder, (_, _, _, _, _) -> {
            throw new IOException("no space left");
        });
        recorder.offer(WIDTH, HEIGHT, frame(1), true);
        recorder.close();
        assertThat(recorder.progress().failure()).contains("Recording has stopped: no space left");
        assertThat(recorder.offer(WIDTH, HEIGHT, frame(1), true)).isFalse();
    }

    @Test
    void anyOtherFailureEndsItToo() throws IOException {
        FrameRecorder recorder = FrameRecorder.start(folder, (_, _, _, _, _) -> {
            throw new OutOfMemoryError("of the test");
        });
        recorder.offer(WIDTH, HEIGHT, frame(1), true);
        recorder.close();
        assertThat(recorder.progress())
                .isEqualTo(new FrameRecorder.Progress(
                        0, 0, Optional.of("Recording has stopped: there is not enough memory for its frames")));
    }

    @Test
    void aFrameThatCannotBeCopiedEndsItAndThoseBeforeAreWritten() throws IOException {
        FrameRecorder recorder = FrameRecorder.start(folder);
        recorder.offer(WIDTH, HEIGHT, frame(1), true);
        assertThat(recorder.offer(WIDTH, 2 * HEIGHT, frame(2), true)).isFalse();
        recorder.close();
        assertThat(recorder.progress().written()).isEqualTo(1);
        assertThat(recorder.progress().failure()).isPresent();
        assertThat(folder.resolve("frame-000001.png")).exists();
    }

    @Test
    void anOlderRecordingIsContinuedWhateverTheLanguagesDigits() throws IOException {
        Locale usual = Locale.getDefault(Locale.Category.FORMAT);
        Locale.setDefault(Locale.Category.FORMAT, Locale.forLanguageTag("ar-EG-u-nu-arab"));
        try {
            FrameRecorder recorder = FrameRecorder.start(folder);
            recorder.offer(WIDTH, HEIGHT, frame(1), true);
            recorder.close();
        } finally {
            Locale.setDefault(Locale.Category.FORMAT, usual);
        }
        assertThat(folder.resolve("frame-000001.png")).exists();
    }

    @Test
    void afterTheEndNothingIsTaken() throws IOException {
        FrameRecorder recorder = FrameRecorder.start(folder);
        recorder.close();
        assertThat(recorder.offer(WIDTH, HEIGHT, frame(1), true)).isFalse();
        recorder.close();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aFolderMustBeThere() {
        assertThatThrownBy(() -> FrameRecorder.start(folder.resolve("no")))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("there is no such folder");
    }
}
