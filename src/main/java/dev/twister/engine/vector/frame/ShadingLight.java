package dev.twister.engine.vector.frame;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Shadow;
import dev.twister.world.FrameInput;

/** A light of a frame, as shading and shadows read it. */
public final class ShadingLight {
    /** The light's body. */
    public int body;

    /** Its center, in meters. */
    public float x;

    public float y;
    public float z;

    /** Linear color. */
    public float red;

    public float green;
    public float blue;

    /** Factor of what it adds to the brightness of matte surfaces. */
    public float share;

    /** Radius of the disc of shadow samples: twice the light's radius. */
    public float discRadius;

    /** Whether the plane may lie between a body's surface point and a light sample. */
    public boolean planeMayShade;

    /**
     * Takes a light.
     *
     * @param index the light's number, from 0 on
     * @param bodies the same frame's bodies
     * @param planeHeight in meters
     */
    public void take(FrameInput input, int index, BodyColumns bodies, float planeHeight) {
        body = input.light(index);
        x = input.bodies().center(body, 0);
        y = input.bodies().center(body, 1);
        z = input.bodies().center(body, 2);
        float[] looks = input.bodies().looks();
        int look = Layout.LOOK_STRIDE * body;
        red = looks[look];
        green = looks[look + 1];
        blue = looks[look + 2];
        share = looks[look + Layout.LOOK_SHARE];
        discRadius = 2f * input.bodies().size(body);
        float reach = discRadius * Shadow.RELATIVE_MARGIN;
        planeMayShade = (bodies.lowest <= planeHeight && y + reach >= planeHeight)
                || (bodies.highest >= planeHeight && y - reach <= planeHeight);
    }
}
