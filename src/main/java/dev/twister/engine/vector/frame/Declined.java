package dev.twister.engine.vector.frame;

import dev.twister.engine.vector.lanes.BodyList;
import dev.twister.kernel.CameraRay;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Texture;
import dev.twister.kernel.Tone;
import dev.twister.kernel.Variant;
import dev.twister.kernel.Views;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.Arrays;
import java.util.function.IntPredicate;

/** The parts of a frame that lanes decline; the scalar kernel renders them. */
public final class Declined {
    /** With more declined occluders the whole frame is declined, because every shaded point is tested against each. */
    private static final int MOST_OCCLUDERS = 256;

    /** Distance from a center, in radii, within which the camera may be inside the body. */
    private static final float INSIDE = 1.0001f;

    /**
     * Relative to a squared radius: if the camera's squared distance from the center differs by less, rounding decides
     * the sign of hit distances in lanes.
     */
    private static final float ROUNDING = 2e-6f;

    private final IntPredicate bodies;
    private final BodyList occluders = new BodyList();

    private boolean[] declined = {};
    private float[] looks = {};
    private int maps;
    private int count;
    private int end;
    private boolean crowded;
    private boolean any;
    private boolean hits;
    private boolean kernelPaths;
    private boolean frame;

    /**
     * Declines nothing until {@code take} is called.
     *
     * @param bodies the bodies to decline in addition to those that emit or have normal, roughness, emission or other
     *     maps, to transmitting bodies in a crowd or where any takes light, and to meshes that have vertex colors or a
     *     texture that is not filtered or does not repeat
     */
    public Declined(IntPredicate bodies) {
        this.bodies = bodies;
    }

    @SuppressWarnings("ReferenceEquality") // an input's arrays are immutable
    void take(FrameInput input, boolean walk) {
        if (looks != input.bodies().looks()
                || count != input.bodyCount()
                || end != input.bodyEnd()
                || crowded != walk) {
            looks = input.bodies().looks();
            count = input.bodyCount();
            end = input.bodyEnd();
            crowded = walk;
            maps = input.bodies().textures();
            takeBodies(input.bodies());
        }
        int toneMap = (int) input.view().frame()[Layout.TONE_MAP];
        hits = (input.variant(false) & (Variant.MASKS | Variant.TWINS)) != 0
                || occluders.count > MOST_OCCLUDERS
                || input.view().frame()[Layout.CAMERA_PROJECTION] != CameraRay.PERSPECTIVE
                || input.view().frame()[Layout.CAMERA_MEDIUM] > Layout.NOTHING
                || isCameraInside(input)
                || isCameraOnASurface(input);
        boolean picture = input.stageOrView() == Views.FULL;
        kernelPaths = hits || !picture;
        frame = input.tracesPaths()
                ? !picture && input.stageOrView() < Views.GUIDED
                : !picture || hits || hasOtherLights(input) || toneMap < Tone.CLAMP || toneMap > Tone.ACES;
    }

    /** Lanes shade by spheres that shine in all directions. */
    private static boolean hasOtherLights(FrameInput input) {
        boolean found = false;
        for (int light = 0; light < input.lights() && !found; light++) {
            int look = Layout.LOOK_STRIDE * input.light(light);
            found = input.bodies().looks()[look + Layout.LOOK_LIGHT] != Layout.SPHERE_LIGHT;
        }
        return found;
    }

    private static boolean isCameraOnASurface(FrameInput input) {
        boolean on = false;
        for (int body = 0; body < input.bodyCount() && !on; body++) {
            on = body != Layout.PLANE && isCameraOn(input, body);
        }
        for (int light = input.bodies().room(); light < input.bodies().sphereEnd() && !on; light++) {
            on = isCameraOn(input, light);
        }
        return on;
    }

    private static boolean isCameraOn(FrameInput input, int body) {
        float[] places = input.bodies().floats();
        float[] camera = input.view().frame();
        int place = Layout.PLACE_STRIDE * body;
        float x = places[place] - camera[Layout.CAMERA_POSITION];
        float y = places[place + 1] - camera[Layout.CAMERA_POSITION + 1];
        float z = places[place + 2] - camera[Layout.CAMERA_POSITION + 2];
        float radius = places[place + Layout.PLACE_SIZE];
        float aperture = camera[Layout.CAMERA_APERTURE];
        float squared = x * x + y * y + z * z;
        float away = (float) Math.sqrt(squared) - radius;
        boolean throughLens = aperture > 0f && Math.abs(away) <= INSIDE * aperture;
        return throughLens || Math.abs(squared - radius * radius) <= ROUNDING * radius * radius;
    }

    private void takeBodies(Bodies all) {
        int firstMesh = all.firstMesh();
        int room = all.end();
        if (declined.length < room) {
            declined = new boolean[room];
        }
        Arrays.fill(declined, false);
        occluders.reserve(end);
        occluders.clear();
        any = false;
        // Lanes do not know which body a ray is in.
        boolean glass = crowded || all.absorb();
        for (int body = 0; body < count; body++) {
            boolean transmits = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] > 0;
            declined[body] = bodies.test(body) || (transmits && glass) || isThin(body) || emits(body) || hasMaps(body);
            any |= declined[body];
            if (declined[body] && body >= Layout.FIRST_SPHERE) {
                occluders.add(body);
            }
        }
        for (int body = Math.max(count, firstMesh); body < end; body++) {
            declined[body] = bodies.test(body)
                    || emits(body)
                    || isThin(body)
                    || (looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION] > 0 && glass)
                    || hasMaps(body)
                    || isColoredOtherwise(body);
            any |= declined[body];
        }
    }

    private boolean isThin(int body) {
        return looks[Layout.LOOK_STRIDE * body + Layout.LOOK_SHEET] > 0;
    }

    private boolean emits(int body) {
        int look = Layout.LOOK_STRIDE * body;
        float emission = looks[look + Layout.LOOK_EMISSION]
                + looks[look + Layout.LOOK_EMISSION + 1]
                + looks[look + Layout.LOOK_EMISSION + 2];
        return looks[look + Layout.LOOK_LIGHT] <= 0 && emission > 0;
    }

    /** Whether it has maps besides a texture: of emission, roughness, metal, normals, occlusion or transmission. */
    private boolean hasMaps(int body) {
        int number = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        int row = maps + Layout.MAPS_STRIDE * (number - 1);
        boolean found = false;
        for (int map = Layout.MAPS_EMISSION; map < Layout.MAPS_ALPHA && number > 0; map += Layout.MAP_STRIDE) {
            found |= looks[row + map + Layout.MAP_WIDTH] > 0;
        }
        return found || (number > 0 && looks[row + Layout.MAPS_UNLIT] > 0);
    }

    /** Whether a mesh has vertex colors, or a texture that does not repeat, is not filtered or has own coordinates. */
    private boolean isColoredOtherwise(int body) {
        int number = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
        int row = maps + Layout.MAPS_STRIDE * (number - 1);
        boolean otherwise = false;
        if (number > 0) {
            int sampler = (int) looks[row + Layout.MAPS_COLOR + Layout.MAP_SAMPLER];
            otherwise = looks[row + Layout.MAPS_VERTEX_COLORS] > 0
                    || looks[row + Layout.MAPS_COLOR + Layout.MAP_WIDTH] <= 0
                    || sampler % Layout.SAMPLER_NEAREST != Texture.REPEAT * (1 + Layout.SAMPLER_DOWN)
                    || Texture.isNearest(sampler) != 0
                    || sampler >= Layout.SAMPLER_COORDINATES;
        }
        return otherwise;
    }

    /** Whether view rays may start inside a declined body that transmits; lanes do not see it from there. */
    private boolean isCameraInside(FrameInput input) {
        float[] camera = input.view().frame();
        boolean inside = false;
        for (int k = 0; k < occluders.count; k++) {
            int body = occluders.bodies[k];
            float distanceSquared = 0f;
            for (int axis = 0; axis < 3; axis++) {
                float away = input.bodies().center(body, axis) - camera[Layout.CAMERA_POSITION + axis];
                distanceSquared += away * away;
            }
            float reach = INSIDE * input.bodies().size(body) + camera[Layout.CAMERA_APERTURE];
            int look = Layout.LOOK_STRIDE * body;
            inside |= distanceSquared <= reach * reach
                    && looks[look + Layout.LOOK_TRANSMISSION] + looks[look + Layout.LOOK_SHEET] > 0;
        }
        return inside;
    }

    /** Whether the whole frame is declined. */
    public boolean isFrame() {
        return frame;
    }

    /** Whether packets do not find the frame's closest hits. */
    public boolean areHits() {
        return hits;
    }

    /**
     * Whether the kernel follows the frame's paths until made lanes are warm: with guides or layers, or without
     * packets.
     */
    public boolean areKernelPaths() {
        return kernelPaths;
    }

    /** Whether any body is declined. */
    public boolean isAnyBody() {
        return any;
    }

    /** Whether the body is declined. */
    public boolean isBody(int body) {
        return declined[body];
    }

    /** The declined spheres, whose shadows lanes cannot compute. */
    public BodyList occluders() {
        return occluders;
    }
}
