package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.BodyColumns;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.kernel.Illumination;
import dev.twister.kernel.Layout;
import dev.twister.kernel.SurfaceLook;
import dev.twister.world.View;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;

/**
 * Ground tiles with nothing between the ground and the light. No direction is normalized: with v to the eye and l to
 * the light, the half vector is parallel to {@code l |v| + v |l|}. One division serves the cosines of both highlight
 * and light. All lanes are rendered, including those outside the frame.
 */
public final class OpenGround {
    /**
     * Limit of x and z in meters. Farther out, rounding here differs from the kernel's and selects other squares of the
     * checker in too many pixels.
     */
    static final float REACH = 256f;

    private OpenGround() {}

    /**
     * Minimum height in meters. Below it, the products of the distances to eye and light may underflow to 0 and are
     * divisors.
     */
    private static final float LEAST_HEIGHT = 1e-6f;

    /** Whether the frame may have such tiles: eye and light must be above the ground, so that no cosine is negative. */
    static boolean suits(Drawing drawing) {
        return eyeHeight(drawing) > LEAST_HEIGHT && lightHeight(drawing) > LEAST_HEIGHT;
    }

    private static float eyeHeight(Drawing drawing) {
        return drawing.input.view().frame()[Layout.CAMERA_POSITION + 1] - drawing.planeHeight;
    }

    private static float lightHeight(Drawing drawing) {
        return drawing.lights[0].y - drawing.planeHeight;
    }

    /** The highlight's exponent; always an integer in {@link GroundAlone}. */
    static int power(Drawing drawing) {
        return (int) drawing.bodies.reflectivity(Layout.PLANE);
    }

    /** Whether the ground reflects other rays. */
    static boolean mirrors(Drawing drawing) {
        return drawing.bounceLimit > 0 && power(drawing) > 0;
    }

    /** Adds the ground's color in a whole tile. */
    public static void add(Drawing drawing, Tile tile) {
        meet(tile, drawing);
        findCosines(tile, drawing);
        if (power(drawing) % 2 > 0) {
            root(tile);
        }
        raise(tile, drawing);
        shade(tile, drawing);
    }

    /** Writes the view rays' hit points on the plane. */
    public static void meet(Tile tile, Drawing drawing) {
        float[] camera = drawing.input.view().frame();
        View view = drawing.input.view();
        float step = drawing.viewportStep;
        float u = (tile.left + view.sample(tile.sample, 0) - drawing.width * 0.5f) * step;
        float top = drawing.input.firstRow() + tile.top;
        float v = (drawing.input.height() * 0.5f - (top + view.sample(tile.sample, 1))) * step;
        float firstX = CameraLanes.turned(u, v, camera, 0);
        float firstY = CameraLanes.turned(u, v, camera, 1);
        float firstZ = CameraLanes.turned(u, v, camera, 2);
        float acrossX = step * camera[Layout.CAMERA_RIGHT];
        float acrossY = step * camera[Layout.CAMERA_RIGHT + 1];
        float acrossZ = step * camera[Layout.CAMERA_RIGHT + 2];
        float downX = -step * camera[Layout.CAMERA_UP];
        float downY = -step * camera[Layout.CAMERA_UP + 1];
        float downZ = -step * camera[Layout.CAMERA_UP + 2];
        float fromX = camera[Layout.CAMERA_POSITION];
        float fromZ = camera[Layout.CAMERA_POSITION + 2];
        float depth = -eyeHeight(drawing);
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            FloatVector placeX = Lanes.load(t, at + Tile.PLACE_X);
            FloatVector placeY = Lanes.load(t, at + Tile.PLACE_Y);
            FloatVector x = Lanes.fma(placeX, Lanes.all(acrossX), Lanes.fma(placeY, downX, firstX));
            FloatVector y = Lanes.fma(placeX, Lanes.all(acrossY), Lanes.fma(placeY, downY, firstY));
            FloatVector z = Lanes.fma(placeX, Lanes.all(acrossZ), Lanes.fma(placeY, downZ, firstZ));
            FloatVector along = Lanes.all(depth).div(y);
            Lanes.fma(along, x, Lanes.all(fromX)).intoArray(t, at + Tile.POINT_X);
            Lanes.fma(along, z, Lanes.all(fromZ)).intoArray(t, at + Tile.POINT_Z);
        }
    }

    /** Writes the light's cosine and the square of the highlight's cosine. */
    static void findCosines(Tile tile, Drawing drawing) {
        float[] camera = drawing.input.view().frame();
        float lightX = drawing.lights[0].x;
        float lightZ = drawing.lights[0].z;
        float eyeX = camera[Layout.CAMERA_POSITION];
        float eyeZ = camera[Layout.CAMERA_POSITION + 2];
        float eyeY = eyeHeight(drawing);
        float lightY = lightHeight(drawing);
        float eyeSquared = eyeY * eyeY;
        float lightSquared = lightY * lightY;
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            FloatVector x = Lanes.load(t, at + Tile.POINT_X);
            FloatVector z = Lanes.load(t, at + Tile.POINT_Z);
            FloatVector toLightX = Lanes.all(lightX).sub(x);
            FloatVector toLightZ = Lanes.all(lightZ).sub(z);
            FloatVector toEyeX = Lanes.all(eyeX).sub(x);
            FloatVector toEyeZ = Lanes.all(eyeZ).sub(z);
            FloatVector light = Lanes.fma(toLightX, toLightX, Lanes.fma(toLightZ, toLightZ, Lanes.all(lightSquared)))
                    .sqrt();
            FloatVector eye = Lanes.fma(toEyeX, toEyeX, Lanes.fma(toEyeZ, toEyeZ, Lanes.all(eyeSquared)))
                    .sqrt();
            FloatVector halfX = Lanes.fma(toLightX, eye, toEyeX.mul(light));
            FloatVector halfY = Lanes.fma(eye, Lanes.all(lightY), light.mul(eyeY));
            FloatVector halfZ = Lanes.fma(toLightZ, eye, toEyeZ.mul(light));
            FloatVector upwards = halfY.mul(halfY);
            FloatVector squared = Lanes.fma(halfX, halfX, Lanes.fma(halfZ, halfZ, upwards));
            FloatVector inverse = Lanes.all(1f).div(light.mul(squared));
            inverse.mul(squared).mul(lightY).intoArray(t, at + Tile.NORMAL_DOT_LIGHT);
            inverse.mul(light).mul(upwards).intoArray(t, at + Tile.SPECULAR);
        }
    }

    /** Replaces the highlight's squared cosine by the cosine, for odd exponents. */
    static void root(Tile tile) {
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            Lanes.load(t, at + Tile.SPECULAR).sqrt().intoArray(t, at + Tile.SPECULAR);
        }
    }

    /** Raises the highlight's cosines to the exponent (squared ones to half of it), and applies their weight. */
    public static void raise(Tile tile, Drawing drawing) {
        int whole = power(drawing);
        int power = whole % 2 == 0 ? whole / 2 : whole;
        float shine = (whole + 8f) * Illumination.INVERSE_EIGHT_PI * whole * (1f / Layout.MAX_REFLECTIVITY);
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            FloatVector square = Lanes.smaller(Lanes.load(t, at + Tile.SPECULAR), Lanes.all(1f));
            FloatVector result = Lanes.all(shine);
            for (int rest = power; rest > 0; rest = rest >> 1) {
                if ((rest & 1) != 0) {
                    result = result.mul(square);
                }
                square = square.mul(square);
            }
            result.intoArray(t, at + Tile.SPECULAR);
        }
    }

    /** Adds the ground's color, and starts the reflected rays. */
    public static void addAndLeave(Drawing drawing, Tile tile) {
        add(drawing, tile);
        CameraLanes.aim(tile, drawing);
        mirror(tile, drawing);
    }

    /** Reflects the live view rays at their hit points. */
    static void mirror(Tile tile, Drawing drawing) {
        tile.spheres.clear();
        float[] t = tile.values;
        for (int k = 0; k < tile.live.count; k++) {
            int at = tile.live.places[k];
            Lanes.load(t, at + Tile.DIRECTION_Y).neg().intoArray(t, at + Tile.DIRECTION_Y);
            Lanes.load(t, at + Tile.POINT_X).intoArray(t, at + Tile.ORIGIN_X);
            Lanes.all(drawing.planeHeight).intoArray(t, at + Tile.ORIGIN_Y);
            Lanes.load(t, at + Tile.POINT_Z).intoArray(t, at + Tile.ORIGIN_Z);
            Lanes.all(Layout.PLANE).intoArray(t, at + Tile.LEAVING);
        }
    }

    /** Adds the ground's color, and writes the throughput of the reflected rays. */
    public static void shade(Tile tile, Drawing drawing) {
        float[] values = drawing.input.view().frame();
        BodyColumns bodies = drawing.bodies;
        float ambient = drawing.ambient;
        float mirror = drawing.bounceLimit == 0 ? 0f : power(drawing) * (1f / Layout.MAX_REFLECTIVITY);
        float matte = 1f - mirror;
        float red = bodies.red(Layout.PLANE) * matte;
        float green = bodies.green(Layout.PLANE) * matte;
        float blue = bodies.blue(Layout.PLANE) * matte;
        float oddRed = values[Layout.PLANE_ODD_COLOR] * matte;
        float oddGreen = values[Layout.PLANE_ODD_COLOR + 1] * matte;
        float oddBlue = values[Layout.PLANE_ODD_COLOR + 2] * matte;
        float lightRed = drawing.lights[0].red;
        float lightGreen = drawing.lights[0].green;
        float lightBlue = drawing.lights[0].blue;
        float[] t = tile.values;
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            FloatVector x = Lanes.load(t, at + Tile.POINT_X).add(SurfaceLook.CHECKER_SHIFT);
            FloatVector z = Lanes.load(t, at + Tile.POINT_Z).add(SurfaceLook.CHECKER_SHIFT);
            IntVector wholeX = Lanes.truncated(x);
            IntVector wholeZ = Lanes.truncated(z);
            // Truncation rounds negative values up, to the next square; the comparison detects that.
            VectorMask<Float> aboveX = Lanes.toFloats(wholeX).compare(VectorOperators.GT, x);
            VectorMask<Float> aboveZ = Lanes.toFloats(wholeZ).compare(VectorOperators.GT, z);
            VectorMask<Float> odd = wholeX.add(wholeZ)
                    .and(1)
                    .compare(VectorOperators.NE, 0)
                    .cast(Lanes.FLOATS)
                    .xor(aboveX)
                    .xor(aboveZ);
            FloatVector lit = Lanes.larger(Lanes.load(t, at + Tile.NORMAL_DOT_LIGHT), Lanes.all(ambient));
            FloatVector specular = Lanes.load(t, at + Tile.SPECULAR);
            FloatVector sumRed = Lanes.fma(specular, Lanes.all(lightRed), Lanes.load(t, at + Tile.RED));
            FloatVector sumGreen = Lanes.fma(specular, Lanes.all(lightGreen), Lanes.load(t, at + Tile.GREEN));
            FloatVector sumBlue = Lanes.fma(specular, Lanes.all(lightBlue), Lanes.load(t, at + Tile.BLUE));
            Lanes.fma(lit, Lanes.all(red).blend(oddRed, odd), sumRed).intoArray(t, at + Tile.RED);
            Lanes.fma(lit, Lanes.all(green).blend(oddGreen, odd), sumGreen).intoArray(t, at + Tile.GREEN);
            Lanes.fma(lit, Lanes.all(blue).blend(oddBlue, odd), sumBlue).intoArray(t, at + Tile.BLUE);
            lit.mul(mirror).intoArray(t, at + Tile.THROUGHPUT);
        }
    }
}
