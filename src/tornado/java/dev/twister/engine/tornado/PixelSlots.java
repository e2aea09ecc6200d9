package dev.twister.engine.tornado;

import dev.twister.image.Frame;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.ref.WeakReference;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import uk.ac.manchester.tornado.api.types.arrays.IntArray;

/**
 * Slots for the pixels of frames in one array outside the heap. The frames that go round in a window each have a slot,
 * into which they are read back without a copy in Java. A frame keeps its slot for as long as somebody has the frame.
 * The last slot is nobody's; its pixels are copied into the frame.
 */
final class PixelSlots {
    /** What new arrays have, and no kernel writes. */
    static final int NOT_DRAWN = 0;

    /** As many as go round in the window. */
    private static final int FRAMES = 4;

    /** Larger pictures have the last slot alone, because TornadoVM allows itself little of a device's memory. */
    private static final int MOST_PIXELS = 1 << 23;

    private final int room;
    private final IntArray pixels;
    private final List<Slot> slots;

    /** The frame whose pixels are in a slot, if any, and these pixels. */
    private record Slot(WeakReference<Frame> owner, IntBuffer buffer) {
        static Slot free() {
            return new Slot(new WeakReference<>(null), IntBuffer.allocate(0));
        }

        boolean isOf(Frame frame) {
            return owner.refersTo(frame);
        }

        boolean isFree() {
            return owner.refersTo(null);
        }
    }

    /**
     * Makes the array.
     *
     * @param room number of pixels of each slot
     */
    PixelSlots(int room) {
        this.room = room;
        int owned = room > 1 && room <= MOST_PIXELS ? FRAMES : 0;
        slots = new ArrayList<>(Collections.nCopies(owned, Slot.free()));
        pixels = new IntArray(Math.multiplyExact(room, owned + 1));
    }

    IntArray pixels() {
        return pixels;
    }

    /** Number of pixels of each slot. */
    int room() {
        return room;
    }

    /** The number of the first pixel of the frame's slot; a frame without one takes a free one, or the last one. */
    int firstPixel(Frame frame) {
        int slot = slots.size();
        for (int i = slots.size() - 1; i >= 0; i--) {
            slot = slots.get(i).isFree() ? i : slot;
        }
        for (int i = 0; i < slots.size(); i++) {
            slot = slots.get(i).isOf(frame) ? i : slot;
        }
        if (slot < slots.size() && !slots.get(slot).isOf(frame)) {
            int length = frame.width() * frame.height();
            slots.set(
                    slot,
                    new Slot(
                            new WeakReference<>(frame),
                            part(slot, length)
                                    .asByteBuffer()
                                    .order(ByteOrder.nativeOrder())
                                    .asIntBuffer()));
        }
        return slot * room;
    }

    /** Gives a frame the pixels that were read back from {@code firstPixel} on. */
    void hand(Frame frame, int firstPixel) {
        int slot = firstPixel / room;
        if (slot < slots.size()) {
            frame.setPixels(slots.get(slot).buffer());
        } else {
            int[] argb = frame.argb();
            MemorySegment.copy(part(slot, argb.length), ValueLayout.JAVA_INT, 0, argb, 0, argb.length);
        }
    }

    private MemorySegment part(int slot, int length) {
        return pixels.getSegment().asSlice((long) Integer.BYTES * room * slot, (long) Integer.BYTES * length);
    }
}
