package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import org.junit.jupiter.api.Test;

/** Pixels in the array and outside the heap. */
class FramePixelsTest {
    private final Frame frame = Frame.ofPixels(2, 1);

    private static IntBuffer outside(int... pixels) {
        return ByteBuffer.allocateDirect(Integer.BYTES * pixels.length)
                .asIntBuffer()
                .put(0, pixels);
    }

    @Test
    void pixelsOutsideAreReadWithoutACopy() {
        IntBuffer buffer = outside(1, 2);
        frame.setPixels(buffer);
        assertThat(frame.pixels()).isSameAs(buffer);
    }

    @Test
    void theArrayHasThePixelsFromOutside() {
        frame.setPixels(outside(1, 2));
        assertThat(frame.argb()).containsExactly(1, 2);
    }

    @Test
    void whatIsWrittenIntoTheArrayIsSeen() {
        frame.setPixels(outside(1, 2));
        frame.argb()[1] = 3;
        assertThat(frame.pixels()).isEqualTo(IntBuffer.wrap(new int[] {1, 3}));
        assertThat(frame.argb()).containsExactly(1, 3);
    }

    @Test
    void anUnmovedFrameKeepsItsBuffer() {
        assertThat(frame.pixels()).isSameAs(frame.pixels());
    }

    @Test
    void rowsAreCopiedFromOutside() {
        Frame whole = Frame.ofPixels(1, 2);
        whole.setPixels(outside(4, 5));
        assertThat(whole.rows(1, 1).argb()).containsExactly(5);
    }

    @Test
    void bandsAreCopiedFromOutside() {
        Frame band = Frame.ofPixels(2, 1);
        band.setPixels(outside(6, 7));
        frame.put(band, 0);
        assertThat(frame.argb()).containsExactly(6, 7);
    }
}
