package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.image.Frame;
import dev.twister.kernel.Camera;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Shadow;
import dev.twister.world.FrameInput;

/** What all threads read while a frame is drawn: the input, prepared for lanes. */
public final class Drawing {
    public final Shortcuts shortcuts;
    public final Declined declined;

    public final Looks looks = new Looks();
    public final BodyColumns bodies = new BodyColumns();
    public final WideHierarchy hierarchy = new WideHierarchy();
    public final DiscOrders discOrders = new DiscOrders();
    public final PaddedSky sky = new PaddedSky();

    /** The light, as the one sphere of a block. */
    public final SphereColumns light = new SphereColumns();

    /** Whether the hierarchy is walked, as there are many bodies. */
    public boolean crowded;

    public FrameInput input;
    public Frame frame;
    public int width;
    public int rows;
    public int shadowSamples;
    public int bounceLimit;
    public int pixelSamples;
    public float ambient;

    /** Meters of the viewport from one pixel to the next. */
    public float viewportStep;

    public float planeHeight;
    public float planeHalfSide;

    /** The square's center. */
    public float planeX;

    public float planeZ;

    /** The shadow samples' disc: twice the light's radius. */
    public float discRadius;

    /** How low and how high the disc may reach, whichever way it faces, in meters. */
    public float discLow;

    public float discHigh;

    /** Whether any point of a sphere and any sample of the light may lie on different sides of the plane. */
    public boolean planeMayShade;

    /** The unit disc's samples, x and y apart, with as many blanks behind as a load may reach too far. */
    public float[] discX = {};

    public float[] discY = {};

    /** How far the outermost sample lies from the disc's center, as a part of its radius. */
    public float rim;

    /** For frames with all shortcuts, of bodies that lanes know. */
    public Drawing() {
        this(Shortcuts.all(), new Declined(_ -> false));
    }

    public Drawing(Shortcuts shortcuts, Declined declined) {
        this.shortcuts = shortcuts;
        this.declined = declined;
    }

    /**
     * Prepares a frame.
     *
     * @param walk whether the hierarchy is walked
     */
    public void take(FrameInput newInput, Frame newFrame, boolean walk) {
        input = newInput;
        frame = newFrame;
        declined.take(newInput, walk);
        looks.take(newInput);
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
        planeHeight = newInput.bodies().center(Layout.PLANE, 1);
        planeX = newInput.bodies().center(Layout.PLANE, 0);
        planeZ = newInput.bodies().center(Layout.PLANE, 2);
        planeHalfSide = Intersection.PLANE_REACH * newInput.bodies().size(Layout.PLANE);
        discRadius = 2f * newInput.bodies().size(Layout.LIGHT);
        float reach = discRadius * Shadow.RELATIVE_MARGIN;
        discLow = bodies.y[Layout.LIGHT] - reach;
        discHigh = bodies.y[Layout.LIGHT] + reach;
        planeMayShade = (bodies.lowest <= planeHeight && discHigh >= planeHeight)
                || (bodies.highest >= planeHeight && discLow <= planeHeight);
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
        if (shadowSamples >= DiscOrders.FEW) {
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

    public int tilesAcross() {
        return (width + Tile.SIDE - 1) / Tile.SIDE;
    }

    public int tiles() {
        return tilesAcross() * ((rows + Tile.SIDE - 1) / Tile.SIDE);
    }
}
