package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.world.FrameInput;
import java.util.function.IntPredicate;

/** What of a frame lanes do not know, and so decline: the scalar kernel draws it. */
public final class Declined {
    /** Each point that is shaded is tested against every declined occluder: with more of them, the whole frame is declined. */
    private static final int MOST_OCCLUDERS = 256;

    /** The looks that lanes know are the first so many. */
    private static final int KNOWN_LOOKS = Layout.LOOK_REFLECTIVITY + 1;

    /** A camera this near to a surface, in radii, may be inside. */
    private static final float INSIDE = 1.0001f;

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
        frame = toneMap < Tone.CLAMP
                || toneMap > Tone.ACES
                || occluders.count > MOST_OCCLUDERS
                || input.view().camera()[Layout.CAMERA_APERTURE] > 0
                || isCameraInside(input);
    }

    private void takeBodies() {
        if (declined.length < count) {
            declined = new boolean[count];
        }
        occluders.reserve(count);
        occluders.clear();
        any = false;
        for (int body = 0; body < count; body++) {
            boolean transmits = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] > 0;
            boolean tested = bodies.test(body);
            declined[body] = tested || hasUnknownLooks(body);
            any |= declined[body];
            if ((tested || transmits) && body >= Layout.FIRST_SPHERE) {
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

    /** Whether view rays may start inside a body that transmits: lanes do not see it from there. */
    private boolean isCameraInside(FrameInput input) {
        float[] camera = input.view().camera();
        boolean inside = false;
        for (int k = 0; k < occluders.count; k++) {
            int body = occluders.bodies[k];
            float distanceSquared = 0f;
            for (int axis = 0; axis < 3; axis++) {
                float away = input.bodies().center(body, axis) - camera[Layout.CAMERA_POSITION + axis];
                distanceSquared += away * away;
            }
            float reach = INSIDE * input.bodies().size(body);
            inside |=
                    distanceSquared <= reach * reach && looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] > 0;
        }
        return inside;
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

    /** The spheres that lanes cannot shade by. */
    public BodyList occluders() {
        return occluders;
    }
}
