package dev.twister.kernel;

/**
 * Float functions with equal results on every engine, by polynomials, repeated squaring and square roots; devices' own
 * functions differ between drivers. The error bounds are tested against {@code StrictMath}.
 */
public final class KernelMath {
    public static final float PI = 3.1415927f;
    public static final float HALF_PI = 1.5707964f;

    /** Number of binary digits of a fractional exponent that are evaluated; the rest is approximated linearly. */
    public static final int FRACTION_DIGITS = 12;

    /** The arc tangent of a ratio r in [0, 1] is {@code r (1 + ATAN_1 r^2 + ATAN_2 r^4 + ...)}. */
    public static final float ATAN_1 = -0.33333093f;

    public static final float ATAN_2 = 0.19993053f;
    public static final float ATAN_3 = -0.14207132f;
    public static final float ATAN_4 = 0.106546685f;
    public static final float ATAN_5 = -0.07533658f;
    public static final float ATAN_6 = 0.043039143f;
    public static final float ATAN_7 = -0.01628287f;
    public static final float ATAN_8 = 0.0029035176f;

    /** {@code x^(10 / 3)} for x in [0.486, 1] is {@code TEN_THIRDS_0 + TEN_THIRDS_1 x + TEN_THIRDS_2 x^2 + ...}. */
    public static final float TEN_THIRDS_0 = -0.0013424668f;

    public static final float TEN_THIRDS_1 = 0.016488077f;
    public static final float TEN_THIRDS_2 = -0.10223673f;
    public static final float TEN_THIRDS_3 = 0.76444095f;
    public static final float TEN_THIRDS_4 = 0.3976099f;
    public static final float TEN_THIRDS_5 = -0.08731597f;
    public static final float TEN_THIRDS_6 = 0.012356257f;

    /** {@code sin(2 pi x)} for x in [-0.25, 0.25] is {@code x (SINE_0 + SINE_1 x^2 + SINE_2 x^4 + ...)}. */
    public static final float SINE_0 = 6.2831855f;

    public static final float SINE_1 = -41.3417f;
    public static final float SINE_2 = 81.605225f;
    public static final float SINE_3 = -76.70428f;
    public static final float SINE_4 = 42.00978f;
    public static final float SINE_5 = -14.393967f;

    /** The largest exponent of {@link #pow}. */
    public static final float MOST_EXPONENT = 128f;

    private KernelMath() {}

    /** The largest integer not above {@code x}, for |x| below 2^31. */
    public static int floor(float x) {
        int truncated = (int) x;
        return x < truncated ? truncated - 1 : truncated;
    }

    /** {@code 1 / sqrt(squared)}, and 0 for 0, so that normalizing a zero vector leaves it zero. */
    public static float inverseRoot(float squared) {
        // TornadoVM makes the device's rsqrt, which is not rounded as in Java, of 1 divided by a square root alone.
        float root = squared > 0f ? (float) Math.sqrt(squared) : Float.POSITIVE_INFINITY;
        return 1f / root;
    }

    /**
     * {@code base^exponent} for a base in [0, 2] and an exponent in [0, 128]; 0^0 is 1. The relative error is below
     * 4e-5 where base and result are above 1e-30.
     */
    public static float pow(float base, float exponent) {
        int whole = (int) exponent;
        float fraction = exponent - whole;
        float result = wholePower(base, whole);
        if (fraction > 0f) {
            result = result * fractionalPower(base, fraction);
        }
        return result;
    }

    /** {@code base^exponent} for a base in [0, 2] and an integer exponent in [0, 255], by its binary digits. */
    static float wholePower(float base, int exponent) {
        int rest = exponent;
        float square = base;
        float result = 1f;
        for (int bit = 0; bit < 8; bit++) {
            result = (rest & 1) != 0 ? result * square : result;
            square = square * square;
            rest = rest / 2;
        }
        return result;
    }

    /** {@code base^fraction} for a fraction in [0, 1), by its binary digits with a square root each. */
    static float fractionalPower(float base, float fraction) {
        float root = base;
        float rest = fraction;
        float result = 1f;
        for (int digit = 0; digit < FRACTION_DIGITS; digit++) {
            root = (float) Math.sqrt(root);
            rest = 2f * rest;
            float taken = rest >= 1f ? 1f : 0f;
            result = taken > 0f ? result * root : result;
            rest = rest - taken;
        }
        return result * (1f + rest * (root - 1f));
    }

    /** The angle of (x, y) in radians, in [-pi, pi], within 4e-7; 0 for (0, 0). */
    public static float atan2(float y, float x) {
        float absX = Math.abs(x);
        float absY = Math.abs(y);
        float larger = absX > absY ? absX : absY;
        float smaller = absX > absY ? absY : absX;
        float ratio = larger > 0f ? smaller / larger : 0f;
        float octant = atanOfRatio(ratio);
        float quadrant = absY > absX ? HALF_PI - octant : octant;
        float half = x < 0f ? PI - quadrant : quadrant;
        return y < 0f ? -half : half;
    }

    /** The sine of an angle in turns, in [0, 1), within 4e-7. */
    static float sineOfTurns(float turns) {
        float x = turns > 0.75f ? turns - 1f : turns > 0.25f ? 0.5f - turns : turns;
        float s = x * x;
        float polynomial = SINE_5;
        polynomial = polynomial * s + SINE_4;
        polynomial = polynomial * s + SINE_3;
        polynomial = polynomial * s + SINE_2;
        polynomial = polynomial * s + SINE_1;
        return x * (polynomial * s + SINE_0);
    }

    /** The cosine of an angle in turns, in [0, 1), within 4e-7. */
    static float cosineOfTurns(float turns) {
        return sineOfTurns(turns < 0.75f ? turns + 0.25f : turns - 0.75f);
    }

    /** The arc tangent of a ratio in [0, 1]: a minimax polynomial in its square. */
    private static float atanOfRatio(float ratio) {
        float s = ratio * ratio;
        float polynomial = ATAN_8;
        polynomial = polynomial * s + ATAN_7;
        polynomial = polynomial * s + ATAN_6;
        polynomial = polynomial * s + ATAN_5;
        polynomial = polynomial * s + ATAN_4;
        polynomial = polynomial * s + ATAN_3;
        polynomial = polynomial * s + ATAN_2;
        polynomial = polynomial * s + ATAN_1;
        return ratio * (1f + polynomial * s);
    }

    /**
     * {@code x^(10 / 3)} for x in [0.486, 1], within 1e-6: a minimax polynomial. Applied to an eighth root it gives the
     * power 5/12 of the sRGB transfer function.
     */
    static float tenThirdsPower(float x) {
        float polynomial = TEN_THIRDS_6;
        polynomial = polynomial * x + TEN_THIRDS_5;
        polynomial = polynomial * x + TEN_THIRDS_4;
        polynomial = polynomial * x + TEN_THIRDS_3;
        polynomial = polynomial * x + TEN_THIRDS_2;
        polynomial = polynomial * x + TEN_THIRDS_1;
        return polynomial * x + TEN_THIRDS_0;
    }
}
