package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.SphereColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Intersection;
import dev.twister.kernel.Layout;
import dev.twister.world.FrameInput;
import java.util.Arrays;

/** The state of a frame that all threads read: the input, prepared for lanes. */
public final class Drawing {
    public final Shortcuts shortcuts;
    public final Declined declined;

    public final Looks looks = new Looks();
    public final BodyColumns bodies = new BodyColumns();
    public final WideHierarchy hierarchy = new WideHierarchy();
    public final DiscOrders discOrders = new DiscOrders();
    public final PaddedSky sky = new PaddedSky();

    /** The lights after the first, if {@link #lightSpheres}. */
    public final WideHierarchy lightHierarchy = new WideHierarchy();

    /** A block that begins with the first light. */
    public final SphereColumns firstLight = new SphereColumns();

    /** At least {@link #lightCount} lights. */
    public ShadingLight[] lights = {};

    public int lightCount;

    /** Whether there are lights after the first that rays can meet. */
    public boolean lightSpheres;

    /** Whether there are spots, which some rays pass. */
    public boolean spots;

    /** Whether the light of several lights is summed up: there are several, or one whose share is not 1. */
    public boolean severalLights;

    /** Whether this frame uses the hierarchy, because it has many bodies. */
    public boolean crowded;

    public FrameInput input;
    public Frame frame;
    public FrameStop stop;
    public int width;
    public int rows;
    public int shadowSamples;
    public int bounceLimit;
    public int pixelSamples;
    public float ambient;

    /** Whether view rays start at the points of a lens instead of one point. */
    public boolean lens;

    /** Distance between adjacent pixels on the viewport, in meters. */
    public float viewportStep;

    public float planeHeight;
    public float planeHalfSide;

    /** Center of the plane's square. */
    public float planeX;

    public float planeZ;

    /** x and y of each of the unit disc's samples. */
    public float[] disc = {};

    /** The same in columns, padded by one vector. */
    public float[] discX = {};

    public float[] discY = {};

    /** Distance of the outermost sample from the disc's center, relative to its radius. */
    public float rim;

    /** For frames with all shortcuts and without declined bodies. */
    public Drawing() {
        this(Shortcuts.all(), new Declined(_ -> false));
    }

    public Drawing(Shortcuts shortcuts, Declined declined) {
        this.shortcuts = shortcuts;
        this.declined = declined;
    }

    /** Whether lanes decline the whole frame. */
    public boolean declines(FrameInput other, boolean walk) {
        declined.take(other, walk);
        return declined.isFrame();
    }

    /**
     * Prepares a frame that this thread asks for.
     *
     * @param walk whether to use the hierarchy
     */
    public void take(FrameInput newInput, Frame newFrame, boolean walk) {
        input = newInput;
        frame = newFrame;
        stop = FrameStop.of(newFrame);
        declined.take(newInput, walk);
        looks.take(newInput);
        bodies.take(newInput);
        crowded = walk;
        if (crowded) {
            hierarchy.take(newInput);
        }
        sky.take(newInput);
        float[] values = newInput.view().frame();
        width = newInput.width();
        rows = newInput.rows();
        shadowSamples = newInput.shadowSamples();
        bounceLimit = newInput.bounces();
        pixelSamples = (int) values[Layout.PIXEL_SAMPLES];
        ambient = values[Layout.AMBIENT];
        lens = values[Layout.CAMERA_APERTURE] > 0f;
        viewportStep = CameraRay.step(width, newInput.height());
        planeHeight = newInput.bodies().center(Layout.PLANE, 1);
        planeX = newInput.bodies().center(Layout.PLANE, 0);
        planeZ = newInput.bodies().center(Layout.PLANE, 2);
        planeHalfSide = Intersection.PLANE_REACH * newInput.bodies().size(Layout.PLANE);
        takeLights();
        takeDisc(values);
        float rimX = disc[2 * shadowSamples - 2];
        float rimY = disc[2 * shadowSamples - 1];
        rim = (float) Math.sqrt(rimX * rimX + rimY * rimY);
    }

    private void takeLights() {
        lightCount = input.lights();
        severalLights = input.hasSeveralLights();
        lightSpheres = input.lightRoot().isPresent();
        if (lightSpheres) {
            lightHierarchy.takeLights(input);
        }
        if (lights.length < lightCount) {
            lights = new ShadingLight[lightCount];
            Arrays.setAll(lights, _ -> new ShadingLight());
        }
        spots = false;
        for (int index = 0; index < lightCount; index++) {
            lights[index].take(input, index, bodies, planeHeight);
            spots |= input.isSpot(lights[index].body);
        }
        firstLight.reserveBlocks(1);
        int at = SphereColumns.FIRST;
        firstLight.values[at] = lights[0].x;
        firstLight.values[at + SphereColumns.Y * Lanes.COUNT] = lights[0].y;
        firstLight.values[at + SphereColumns.Z * Lanes.COUNT] = lights[0].z;
        firstLight.values[at + SphereColumns.RADIUS * Lanes.COUNT] =
                input.bodies().size(lights[0].body);
        firstLight.values[at + SphereColumns.BODY * Lanes.COUNT] = lights[0].body;
    }

    /** Whether the plane or a declined body may lie between a surface point and the light. */
    public boolean mayDeclineShadows(ShadingLight light) {
        return declined.occluders().count > 0 || light.planeMayShade;
    }

    private void takeDisc(float[] values) {
        int end = Layout.DISC + 2 * shadowSamples;
        if (!Arrays.equals(disc, 0, disc.length, values, Layout.DISC, end)) {
            disc = Arrays.copyOfRange(values, Layout.DISC, end);
            discX = new float[shadowSamples + Lanes.COUNT];
            discY = new float[shadowSamples + Lanes.COUNT];
            for (int sample = 0; sample < shadowSamples; sample++) {
                discX[sample] = disc[2 * sample];
                discY[sample] = disc[2 * sample + 1];
            }
        }
        if (shadowSamples >= DiscOrders.FEW) {
            discOrders.take(disc, shadowSamples);
        }
    }

    public int tilesAcross() {
        return (width + Tile.SIDE - 1) / Tile.SIDE;
    }

    public int tiles() {
        return tilesAcross() * ((rows + Tile.SIDE - 1) / Tile.SIDE);
    }
}
