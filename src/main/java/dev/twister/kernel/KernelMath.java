package dev.twister.kernel;

/**
 * Float functions that give the same numbers on every engine: polynomials, repeated squaring and square roots, where
 * devices' own functions differ from driver to driver. The bounds given here are tested against {@code StrictMath}.
 */
public final class KernelMath {
    private static final float PI = 3.1415927f;
    private static final float HALF_PI = 1.5707964f;

    private KernelMath() {}

    /** The largest whole number that is not above {@code x}, for |x| below 2^31. */
    public static int floor(float x) {
        int truncated = (int) x;
        return x < truncated ? truncated - 1 : truncated;
    }

    /** {@code 1 / sqrt(squared)}, and 0 for 0, so that normalising a zero vector leaves it zero. */
    public static float inverseRoot(float squared) {
        return squared > 0f ? 1f / (float) Math.sqrt(squared) : 0f;
    }

    /**
     * {@code base^exponent} for a base in [0, 2] and an exponent in [0, 128]; 0^0 is 1. The relative error is below
     * 4e-5 where base and result are above 1e-30.
     */
    public static float pow(float base, float exponent) {
        int whole = (int) exponent;
        float fraction = exponent - whole;
        float square = base;
        float result = 1f;
        for (int bit = 0; bit < 8; bit++) {
            result = (whole & 1) != 0 ? result * square : result;
            square = square * square;
            whole = whole / 2;
        }
        if (fraction > 0f) {
            result = result * fractionalPow(base, fraction);
        }
        return result;
    }

    /** {@code base^fraction}, fraction in (0, 1), by its binary digits: each takes one more square root. */
    private static float fractionalPow(float base, float fraction) {
        float root = base;
        float rest = fraction;
        float result = 1f;
        for (int digit = 0; digit < 12; digit++) {
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

    /** The arc tangent of a ratio in [0, 1]: a minimax polynomial in its square. */
    private static float atanOfRatio(float ratio) {
        float s = ratio * ratio;
        float polynomial = 0.0029035176f;
        polynomial = polynomial * s - 0.01628287f;
        polynomial = polynomial * s + 0.043039143f;
        polynomial = polynomial * s - 0.07533658f;
        polynomial = polynomial * s + 0.106546685f;
        polynomial = polynomial * s - 0.14207132f;
        polynomial = polynomial * s + 0.19993053f;
        polynomial = polynomial * s - 0.33333093f;
        return ratio * (1f + polynomial * s);
    }

    /**
     * {@code x^(10 / 3)} for x in [0.486, 1], within 1e-6: a minimax polynomial. Of an eighth root it is the 5/12th
     * power, which is the sRGB curve's.
     */
    static float tenThirdsPower(float x) {
        float polynomial = 0.012356257f;
        polynomial = polynomial * x - 0.08731597f;
        polynomial = polynomial * x + 0.3976099f;
        polynomial = polynomial * x + 0.76444095f;
        polynomial = polynomial * x - 0.10223673f;
        polynomial = polynomial * x + 0.016488077f;
        return polynomial * x - 0.0013424668f;
    }
}
