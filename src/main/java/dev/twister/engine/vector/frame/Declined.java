package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.world.FrameInput;
import java.util.function.IntPredicate;

/** What of a frame lanes do not know, and so decline: the scalar kernel draws it. */
public final class Declined {
    /** Each point that is shaded is tested against every declined sphere: with more of them, the whole frame is declined. */
    private static final int MOST_OCCLUDERS = 256;

    /** The looks that lanes know are the first so many. */
    private static final int KNOWN_LOOKS = Layout.LOOK_REFLECTIVITY + 1;

    private final IntPredicate bodies;
    private final BodyList occluders = new BodyList();
    private boolean[] declined = {};
    private float[] looks = {};
    private int count;
    private boolean any;
    private boolean frame;

    /**
     * Declines nothing until a frame is taken.
     *
     * @param bodies tells which bodies are declined beside those that have looks other than color and reflectivity
     */
    public Declined(IntPredicate bodies) {
        this.bodies = bodies;
    }

    @SuppressWarnings("ReferenceEquality") // an input's arrays never change
    void take(FrameInput input) {
        if (looks != input.bodies().looks() || count != input.bodyCount()) {
            looks = input.bodies().looks();
            count = input.bodyCount();
            takeBodies();
        }
        int toneMap = (int) input.view().properties()[Layout.TONE_MAP];
        frame = toneMap < Tone.CLAMP || toneMap > Tone.ACES || occluders.count > MOST_OCCLUDERS;
    }

    private void takeBodies() {
        if (declined.length < count) {
            declined = new boolean[count];
        }
        occluders.reserve(count);
        occluders.clear();
        any = false;
        for (int body = 0; body < count; body++) {
            declined[body] = bodies.test(body) || hasUnknownLooks(body);
            any |= declined[body];
            if (declined[body] && body >= Layout.FIRST_SPHERE) {
                occluders.add(body);
            }
        }
    }

    private boolean hasUnknownLooks(int body) {
        boolean unknown = false;
        for (int look = KNOWN_LOOKS; look < Layout.LOOK_STRIDE; look++) {
            unknown |= looks[Layout.LOOK_STRIDE * body + look] != 0f;
        }
        return unknown;
    }

    /** Whether all of the frame is. */
    public boolean isFrame() {
        return frame;
    }

    /** Whether any body is. */
    public boolean isAnyBody() {
        return any;
    }

    /** Whether that body is. */
    public boolean isBody(int body) {
        return declined[body];
    }

    /** The spheres that are. */
    public BodyList occluders() {
        return occluders;
    }
}
