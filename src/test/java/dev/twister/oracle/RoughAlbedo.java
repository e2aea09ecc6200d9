package dev.twister.oracle;

import java.util.function.DoubleUnaryOperator;

/** What facets of one roughness scatter once of white light, by the cosine of its direction. */
final class RoughAlbedo {
    private static final int COSINES = 200;
    private static final int STEPS = 48;
    private static final Vector NORMAL = new Vector(0, 0, 1);

    /** At the middles of equal steps of the root of the cosine. */
    private final double[] values = new double[COSINES];

    private final double mean;

    private RoughAlbedo(DoubleUnaryOperator albedo) {
        double sum = 0;
        for (int i = 0; i < COSINES; i++) {
            double root = (i + 0.5) / COSINES;
            values[i] = albedo.applyAsDouble(root * root);
            sum += values[i] * 4 * root * root * root / COSINES;
        }
        mean = sum;
    }

    /** Of a perfect mirror. */
    static RoughAlbedo ofMirror(double roughness) {
        return new RoughAlbedo(cosine -> integral(roughness, cosine, 1, true, false));
    }

    /** Of what a dielectric reflects. */
    static RoughAlbedo ofCoat(double roughness, double ratio) {
        return new RoughAlbedo(cosine -> integral(roughness, cosine, ratio, false, false));
    }

    /** Of what a dielectric reflects and refracts. */
    static RoughAlbedo ofGlass(double roughness, double ratio) {
        return new RoughAlbedo(cosine -> integral(roughness, cosine, ratio, false, true));
    }

    double of(double cosine) {
        double place = Math.clamp(Math.sqrt(Math.max(0, cosine)) * COSINES - 0.5, 0, COSINES - 1.001);
        int left = (int) place;
        return values[left] + (place - left) * (values[left + 1] - values[left]);
    }

    double mean() {
        return mean;
    }

    private static double integral(double roughness, double cosine, double ratio, boolean mirror, boolean refracts) {
        RoughSurface surface = RoughSurface.of(roughness);
        Vector toViewer = new Vector(Math.sqrt(1 - cosine * cosine), 0, cosine);
        double sum = 0;
        for (int i = 0; i < STEPS * STEPS; i++) {
            int row = i / STEPS;
            // An irrational shift of each row avoids a grid's steps.
            double turns = (i % STEPS + row * 0.6180339887 % 1) / STEPS;
            Vector facet = surface.facet(NORMAL, toViewer, turns, (row + 0.5) / STEPS);
            double dot = Math.clamp(toViewer.dot(facet), 0, 1);
            double fresnel = mirror ? 1 : Fresnel.reflectance(dot, ratio);
            Vector reflected = facet.times(2 * dot).minus(toViewer);
            sum += fresnel * surface.weight(cosine, reflected.dot(NORMAL));
            if (refracts && fresnel < 1) {
                Vector refracted =
                        Fresnel.refracted(toViewer.times(-1), facet, ratio).normalized();
                sum += (1 - fresnel) * surface.weight(cosine, -refracted.dot(NORMAL));
            }
        }
        return sum / (STEPS * STEPS);
    }
}
