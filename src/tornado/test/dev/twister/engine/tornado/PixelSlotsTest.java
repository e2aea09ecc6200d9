package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.Frame;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class PixelSlotsTest {
    private static final int ROOM = 8;

    private final PixelSlots slots = new PixelSlots(ROOM);

    private static List<Frame> frames(int count) {
        return Stream.generate(() -> Frame.ofPixels(3, 2)).limit(count).toList();
    }

    @Test
    void theFramesOfAWindowHaveSlotsOfTheirOwn() {
        List<Frame> frames = frames(4);
        assertThat(frames.stream().map(slots::firstPixel)).doesNotHaveDuplicates();
        assertThat(frames.stream().map(slots::firstPixel)).containsExactly(0, ROOM, 2 * ROOM, 3 * ROOM);
    }

    @Test
    void aFramesPixelsAreInItsSlotWithoutACopy() {
        List<Frame> frames = frames(2);
        frames.forEach(slots::firstPixel);
        Frame second = frames.getLast();
        slots.hand(second, slots.firstPixel(second));
        slots.pixels().set(ROOM + 5, 42);
        assertThat(second.pixels().isDirect()).isTrue();
        assertThat(second.pixels().capacity()).isEqualTo(6);
        assertThat(second.pixels().get(5)).isEqualTo(42);
    }

    @Test
    void aFrameTooManyGetsACopy() {
        List<Frame> frames = frames(5);
        frames.forEach(slots::firstPixel);
        Frame fifth = frames.getLast();
        int firstPixel = slots.firstPixel(fifth);
        slots.pixels().set(firstPixel + 5, 42);
        slots.hand(fifth, firstPixel);
        slots.pixels().set(firstPixel + 5, 43);
        assertThat(fifth.pixels().isDirect()).isFalse();
        assertThat(fifth.argb()[5]).isEqualTo(42);
    }

    @Test
    void vastPicturesAreCopied() {
        int vast = (1 << 23) + 1;
        assertThat(new PixelSlots(vast).pixels().getSize()).isEqualTo(vast);
    }
}
