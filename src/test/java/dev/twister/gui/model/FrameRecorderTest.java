package dev.twister.gui.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.IntBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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
        recorder.offer(WIDTH, HEIGHT, shared);
        // The window draws over its buffer at once.
        shared.put(0, frame(20), 0, WIDTH * HEIGHT);
        recorder.offer(WIDTH, HEIGHT, shared);
        recorder.close();
        assertThat(recorder.progress()).isEqualTo(new FrameRecorder.Progress(2, 0, 0, Optional.empty()));
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
        recorder.offer(WIDTH, HEIGHT, frame(1));
        recorder.close();
        assertThat(folder.resolve("frame-000042.png")).exists();
    }

    @Test
    void whoHandsFramesOverNeverWaits() throws IOException, InterruptedException {
        CountDownLatch writing = new CountDownLatch(1);
        CountDownLatch mayWrite = new CountDownLatch(1);
        FrameRecorder recorder = FrameRecorder.start(folder, (_, _, _, _) -> {
            writing.countDown();
            await(mayWrite);
        });
        int side = 4096;
        IntBuffer large = IntBuffer.allocate(side * side);
        recorder.offer(side, side, large);
        writing.await();
        int taken = 1;
        while (recorder.offer(side, side, large)) {
            taken++;
        }
        assertThat(taken).isEqualTo(4);
        assertThat(recorder.progress().leftOut()).isEqualTo(1);
        assertThat(recorder.progress().waiting()).isEqualTo(taken);
        mayWrite.countDown();
        recorder.close();
        assertThat(recorder.progress().written()).isEqualTo(taken);
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
        FrameRecorder recorder = FrameRecorder.start(folder, (_, _, _, _) -> {
            throw new IOException("no space left");
        });
        recorder.offer(WIDTH, HEIGHT, frame(1));
        recorder.close();
        assertThat(recorder.progress().failure()).contains("Recording has stopped: no space left");
        assertThat(recorder.progress().leftOut()).isEqualTo(1);
        assertThat(recorder.offer(WIDTH, HEIGHT, frame(1))).isFalse();
    }

    @Test
    void afterTheEndNothingIsTaken() throws IOException {
        FrameRecorder recorder = FrameRecorder.start(folder);
        recorder.close();
        assertThat(recorder.offer(WIDTH, HEIGHT, frame(1))).isFalse();
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
