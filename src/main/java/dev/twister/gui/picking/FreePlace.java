package dev.twister.gui.picking;

import dev.twister.gui.edit.Axis;
import dev.twister.gui.edit.BodyExtent;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.scene.property.SceneLimits;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The place of a new body. It stands on the ground where the camera looks, or in the air if the camera looks up; if
 * another body is there, beside that, in view.
 */
final class FreePlace {
    /** The sine of the angle above the horizon from which the camera looks up. */
    private static final double STEEPEST_UP = 0.15;

    /** Meters to the place if the camera looks farther, and this place is in view. */
    private static final double DISTANCE = 15;

    /** The radius of the bodies beside whose middle a new one stands; it stands before larger ones. In meters. */
    private static final double SMALL_BODY = 3;

    /** Meters to other bodies, at least. */
    private static final double GAP = 0.15;

    /** Of the distance to a body's middle, for a point on its surface. */
    private static final double ROUNDING = 1.001;

    private static final double STEP = 0.4;
    private static final int STEPS = 24;

    /** The nearest ones first, and those beside the wanted place before those in front of it and behind it. */
    private static final List<Way> WAYS = IntStream.rangeClosed(-STEPS, STEPS)
            .boxed()
            .flatMap(deep -> IntStream.rangeClosed(-STEPS, STEPS).mapToObj(right -> new Way(right, deep)))
            .sorted(Comparator.comparingDouble(Way::cost).thenComparing(Way::right, Comparator.reverseOrder()))
            .toList();

    /** Costs of a place; see {@link #cost}. */
    private static final int OUT_OF_SIGHT = 2;

    private static final int OF_A_BODY = 4;

    /** Of the picture's height: the radius of a body that may not be cut off. */
    private static final double LARGE = 0.25;

    private final FrameInput input;
    private final Projection projection;
    private final BodyExtent body;

    /** Without those around the camera, such as rooms. */
    private final List<BodyExtent> others;

    private final double ground;
    private final double standing;

    /**
     * From the wanted place, in steps.
     *
     * @param right to the right of the picture
     * @param deep away from the camera
     */
    private record Way(int right, int deep) {
        double cost() {
            return Math.hypot(right, deep < 0 ? 4 * deep : 6 * deep);
        }
    }

    private FreePlace(FrameInput input, Scene scene, SceneMeshes meshes, BodyExtent body) {
        this.input = input;
        this.body = body;
        projection = Projection.of(input);
        ground = scene.ground().height();
        double middle = body.half().y() + body.middle().y();
        standing = scene.camera().position().y() >= ground ? ground + middle : ground - middle;
        others = Stream.of(
                        IntStream.range(0, scene.lights().count())
                                .filter(light -> !scene.lights().get(light).isSun())
                                .map(BodyNumber::ofLight),
                        IntStream.range(0, scene.spheres().size()).map(BodyNumber::ofSphere),
                        IntStream.range(0, scene.meshes().size()).map(BodyNumber::ofMesh))
                .flatMapToInt(numbers -> numbers)
                .mapToObj(number -> BodyExtent.of(scene, meshes, number))
                .filter(other -> !other.isNear(BodyExtent.ball(projection.viewpoint(), 0), 0))
                .toList();
    }

    /**
     * The place of the body's middle.
     *
     * @param input of the picture that is shown
     * @param scene with its bodies where they are seen
     * @param meshes of the picture
     * @param body its middle is that number of meters above where the body stands
     */
    static Vector3 of(FrameInput input, Scene scene, SceneMeshes meshes, BodyExtent body) {
        FreePlace places = new FreePlace(input, scene, meshes, body);
        return places.nearest(places.wanted());
    }

    private Vector3 wanted() {
        PointerRay ray = PointerRay.through(input, input.width() / 2.0, input.height() / 2.0);
        return small(ray).map(BodyExtent::middle).map(this::onGround).orElseGet(() -> before(ray));
    }

    /** The body that is seen, if it is a small one. */
    private Optional<BodyExtent> small(PointerRay ray) {
        Vector3 seen = ray.along(ray.distance());
        return Optional.of(ray)
                .filter(met -> met.body() != Layout.NOTHING && met.body() != Layout.PLANE)
                .flatMap(_ -> others.stream()
                        .filter(other -> other.radius() <= SMALL_BODY
                                && seen.minus(other.middle()).length() <= ROUNDING * other.radius())
                        .min(Comparator.comparingDouble(
                                other -> seen.minus(other.middle()).length())));
    }

    private Vector3 before(PointerRay ray) {
        double inFront = ray.body() == Layout.PLANE ? 0 : body.radius();
        double met = ray.body() == Layout.NOTHING ? Double.POSITIVE_INFINITY : ray.distance() - inFront;
        double down = (ground - projection.viewpoint().y()) / ray.direction(1);
        double meters = Math.max(2 * body.radius(), Math.min(met, down > 0 ? down : Double.POSITIVE_INFINITY));
        Vector3 near = standing(ray, Math.min(meters, DISTANCE));
        return meters > DISTANCE && Double.isFinite(meters) && !isInPicture(near, 1) ? standing(ray, meters) : near;
    }

    private Vector3 standing(PointerRay ray, double meters) {
        Vector3 place = ray.along(meters);
        boolean inAir = ray.direction(1) > STEEPEST_UP && standing > ground;
        return inAir ? Axis.Y.with(place, Math.max(place.y() + body.middle().y(), standing)) : onGround(place);
    }

    private Vector3 onGround(Vector3 place) {
        return Axis.Y.with(place, standing);
    }

    private Vector3 nearest(Vector3 wanted) {
        Vector3 right = projection.right();
        Vector3 deep = new Vector3(-right.z(), 0, right.x());
        BodyExtent reached =
                BodyExtent.ball(SceneLimits.POSITION.clamp(wanted), Math.sqrt(2) * STEPS * STEP + body.radius());
        List<BodyExtent> near =
                others.stream().filter(other -> other.isNear(reached, GAP)).toList();
        Vector3 best = wanted;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < WAYS.size() && least > 0; i++) {
            Way way = WAYS.get(i);
            Vector3 place = SceneLimits.POSITION.clamp(
                    wanted.plus(right.times(way.right() * STEP)).plus(deep.times(way.deep() * STEP)));
            int cost = cost(place, near, least);
            if (cost < least) {
                least = cost;
                best = place;
            }
        }
        return best;
    }

    /**
     * 0 for a free place in view, more where the body is cut off, out of sight or where other bodies are.
     *
     * @param near all bodies that may be there
     * @param least counting ends above it
     */
    private int cost(Vector3 place, List<BodyExtent> near, int least) {
        BodyExtent there = new BodyExtent(place, body.radius(), body.half());
        int taken = (int) near.stream()
                .filter(other -> there.isNear(other, GAP))
                .limit(least / OF_A_BODY + 1)
                .count();
        int atCamera = distance(place) < 2 * body.radius() ? 1 : 0;
        return OF_A_BODY * (taken + atCamera) + (isSeen(place) ? cutOff(place) : OUT_OF_SIGHT);
    }

    private int cutOff(Vector3 place) {
        return isInPicture(place, 1)
                ? 0
                : size(place) < LARGE * input.height() && isInPicture(place, 0) ? 1 : OUT_OF_SIGHT;
    }

    /** @param part of the radius that is in the picture to all sides */
    private boolean isInPicture(Vector3 place, double part) {
        double[] pixel = projection.point(place);
        double inset = part * size(place);
        return pixel.length > 0
                && pixel[0] >= inset
                && pixel[0] <= input.width() - inset
                && pixel[1] >= inset
                && pixel[1] <= input.height() - inset;
    }

    /** The radius in pixels. */
    private double size(Vector3 place) {
        return body.radius() * projection.pixelsPerMeter(place);
    }

    /** Whether nothing hides it. */
    private boolean isSeen(Vector3 place) {
        double[] pixel = projection.point(place);
        if (pixel.length == 0) {
            return false;
        }
        PointerRay ray = PointerRay.through(input, pixel[0], pixel[1]);
        return ray.body() == Layout.NOTHING || ray.distance() >= distance(place) - body.radius();
    }

    private double distance(Vector3 place) {
        return place.minus(projection.viewpoint()).length();
    }
}
