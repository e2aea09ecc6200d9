package dev.twister.world;

import dev.twister.kernel.Layout;

/** The bodies' centers alone. */
public final class Positions {
    private Positions() {}

    /** {@code float[3 * room]}, as {@link World#setBodyPositions} takes them. */
    public static float[] of(FrameInput input) {
        float[] places = input.bodies().places();
        float[] positions = new float[3 * input.bodies().room()];
        for (int body = 0; body < input.bodies().room(); body++) {
            System.arraycopy(places, Layout.PLACE_STRIDE * body, positions, 3 * body, 3);
        }
        return positions;
    }
}
