package dev.twister.engine.vector;

import dev.twister.image.Frame;
import dev.twister.kernel.Camera;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;

/** What all threads read while a frame is drawn: the input, prepared for lanes. */
final class Drawing {
    final BodyColumns bodies = new BodyColumns();
    final WideHierarchy hierarchy = new WideHierarchy();
    final DiscOrders discOrders = new DiscOrders();
    final PaddedSky sky = new PaddedSky();

    /** The light, as the one sphere of a block. */
    final SphereColumns light = new SphereColumns();

    /** Whether the hierarchy is walked, as there are many bodies. */
    boolean crowded;

    FrameInput input;
    Frame frame;
    int width;
    int rows;
    int shadowSamples;
    int bounceLimit;
    int pixelSamples;
    float ambient;

    /** Metres of the viewport from one pixel to the next. */
    float viewportStep;

    float planeHeight;
    float planeHalfSide;

    /** The shadow samples' disc: twice the light's radius. */
    float discRadius;

    /** The unit disc's samples, x and y apart, with as many blanks behind as a load may reach too far. */
    float[] discX = {};

    float[] discY = {};

    /** How far the outermost sample lies from the disc's centre, as a part of its radius. */
    float rim;

    /**
     * Prepares a frame.
     *
     * @param walk whether the hierarchy is walked
     */
    void take(FrameInput newInput, Frame newFrame, boolean walk) {
        input = newInput;
        frame = newFrame;
        bodies.take(newInput);
        crowded = walk;
        if (crowded) {
            hierarchy.take(newInput);
            takeLight();
        }
        sky.take(newInput);
        float[] properties = newInput.view().properties();
        width = newInput.width();
        rows = newInput.rows();
        shadowSamples = newInput.shadowSamples();
        bounceLimit = newInput.bounces();
        pixelSamples = (int) properties[Layout.PIXEL_SAMPLES];
        ambient = properties[Layout.AMBIENT];
        viewportStep = Camera.step(width, newInput.height());
        planeHeight = newInput.bodies().places()[Layout.PLACE_STRIDE * Layout.PLANE + 1];
        planeHalfSide = Intersection.PLANE_REACH
                * newInput.bodies().places()[Layout.PLACE_STRIDE * Layout.PLANE + Layout.PLACE_SIZE];
        discRadius = 2f * newInput.bodies().places()[Layout.PLACE_STRIDE * Layout.LIGHT + Layout.PLACE_SIZE];
        takeDisc(newInput.view().shadowDisc());
        float rimX = newInput.view().shadowDisc()[2 * shadowSamples - 2];
        float rimY = newInput.view().shadowDisc()[2 * shadowSamples - 1];
        rim = (float) Math.sqrt(rimX * rimX + rimY * rimY);
    }

    private void takeLight() {
        light.reserveBlocks(1);
        int at = SphereColumns.FIRST;
        light.values[at] = bodies.x[Layout.LIGHT];
        light.values[at + SphereColumns.Y * Lanes.COUNT] = bodies.y[Layout.LIGHT];
        light.values[at + SphereColumns.Z * Lanes.COUNT] = bodies.z[Layout.LIGHT];
        light.values[at + SphereColumns.RADIUS * Lanes.COUNT] = bodies.radius[Layout.LIGHT];
        light.values[at + SphereColumns.BODY * Lanes.COUNT] = Layout.LIGHT;
    }

    private void takeDisc(float[] disc) {
        if (shadowSamples >= ShadowRange.FEW) {
            discOrders.take(disc, shadowSamples);
        }
        if (discX.length < shadowSamples + Lanes.COUNT) {
            discX = new float[shadowSamples + Lanes.COUNT];
            discY = new float[shadowSamples + Lanes.COUNT];
        }
        for (int sample = 0; sample < shadowSamples; sample++) {
            discX[sample] = disc[2 * sample];
            discY[sample] = disc[2 * sample + 1];
        }
    }

    int tilesAcross() {
        return (width + Tile.SIDE - 1) / Tile.SIDE;
    }

    int tiles() {
        return tilesAcross() * ((rows + Tile.SIDE - 1) / Tile.SIDE);
    }
}
