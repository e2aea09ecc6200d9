package dev.twister.world;

import dev.twister.kernel.Layout;

/** Extracts the centers of bodies. */
public final class Positions {
    private Positions() {}

    /** Returns {@code float[3 * room]} as for {@link World#setBodyPositions}. */
    public static float[] of(FrameInput input) {
        float[] places = input.bodies().floats();
        float[] positions = new float[3 * input.bodies().room()];
        for (int body = 0; body < input.bodies().room(); body++) {
            System.arraycopy(places, Layout.PLACE_STRIDE * body, positions, 3 * body, 3);
        }
        return positions;
    }
}
