package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/** The bodies' material properties beyond color and reflectivity. Reused while the input's array is the same. */
public final class Looks {
    /** First and number of the properties that lanes read: from the roughness to the metallic part. */
    public static final int FIRST = Layout.LOOK_ROUGHNESS;

    public static final int COUNT = Layout.LOOK_METALLIC + 1 - FIRST;

    /** {@link Layout#LOOK_STRIDE} floats per body. */
    public float[] values = {};

    /**
     * The properties from {@link #FIRST} on in columns of {@link Lanes#COUNT} from {@link Lanes#BORDER} on; only filled
     * where one vector holds all bodies.
     */
    public final float[] columns = new float[Lanes.BORDER + COUNT * Lanes.COUNT];

    /** Whether any body has a texture. */
    public boolean textured;

    /** Whether any body is rough. */
    public boolean rough;

    /** Whether any body transmits. */
    public boolean transparent;

    /** Whether any body tints what it reflects. */
    public boolean metallic;

    /** Whether the plane has only color and reflectivity. */
    public boolean plainPlane;

    private int bodies;
    private boolean traced;

    @SuppressWarnings("ReferenceEquality") // an input's arrays are immutable
    void take(FrameInput input) {
        if (values != input.bodies().looks() || bodies != input.bodyEnd() || traced != input.tracesPaths()) {
            values = input.bodies().looks();
            bodies = input.bodyEnd();
            traced = input.tracesPaths();
            copy();
        }
    }

    private void copy() {
        textured = false;
        rough = false;
        transparent = false;
        metallic = false;
        for (int body = 0; body < bodies; body++) {
            textured |= look(body, Layout.LOOK_MAPS) > 0f;
            rough |= look(body, Layout.LOOK_ROUGHNESS) > 0f;
            transparent |= transmits(body);
            metallic |= look(body, Layout.LOOK_METALLIC) > 0f;
            for (int look = 0; look < COUNT && bodies <= Lanes.COUNT; look++) {
                columns[Lanes.BORDER + look * Lanes.COUNT + body] = look(body, FIRST + look);
            }
        }
        plainPlane = true;
        for (int look = FIRST; look < Layout.LOOK_STRIDE; look++) {
            plainPlane &= look(Layout.PLANE, look) == 0f;
        }
    }

    private float look(int body, int look) {
        return values[Layout.LOOK_STRIDE * body + look];
    }

    /** Transmission in [0, 1]. */
    public float transmission(int body) {
        return look(body, Layout.LOOK_TRANSMISSION);
    }

    /** Whether light passes the body's surface; that of a diffuse sheet in path tracing alone. */
    public boolean transmits(int body) {
        return transmission(body) > 0f || (traced && look(body, Layout.LOOK_SHEET) > 0f);
    }

    /** Whether secondary rays may be tinted or split, and wait in a tile of branch rays. */
    public boolean isBranching() {
        return transparent || metallic;
    }

    /** Whether any body has more than color and reflectivity. */
    public boolean isAny() {
        return textured || rough || isBranching();
    }
}
