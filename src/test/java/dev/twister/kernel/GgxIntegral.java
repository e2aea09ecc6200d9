package dev.twister.kernel;

/**
 * GGX's distribution of visible normals by numerical integration, in a frame whose z is the surface's normal and whose view
 * direction has no y. Normals are counted by azimuth and by q = tan^2 / (alpha^2 + tan^2) of their angle, in which the
 * distribution of all normals is even.
 */
final class GgxIntegral {
    private static final int HEIGHTS = 4000;
    private static final int AZIMUTHS = 720;

    private final double alpha;
    private final double viewX;
    private final double viewZ;

    /** A function of a normal. */
    @FunctionalInterface
    interface Value {
        double at(double x, double y, double z);
    }

    GgxIntegral(double roughness, double viewCosine) {
        alpha = roughness * roughness;
        viewX = Math.sqrt(1 - viewCosine * viewCosine);
        viewZ = viewCosine;
    }

    /** The function's mean over the visible normals. */
    double mean(Value value) {
        double sum = 0;
        double first = 1 / (1 + lambda(viewZ));
        for (int height = 0; height < HEIGHTS; height++) {
            double q = (height + 0.5) / HEIGHTS;
            double z = 1 / Math.sqrt(1 + alpha * alpha * q / (1 - q));
            double sine = Math.sqrt(1 - z * z);
            for (int azimuth = 0; azimuth < AZIMUTHS; azimuth++) {
                double angle = (azimuth + 0.5) * 2 * Math.PI / AZIMUTHS;
                double x = sine * Math.cos(angle);
                double cosine = x * viewX + z * viewZ;
                if (cosine > 0) {
                    sum += first * cosine / viewZ / z * value.at(x, sine * Math.sin(angle), z);
                }
            }
        }
        return sum / HEIGHTS / AZIMUTHS;
    }

    /** What part of white light a mirror of these normals reflects: G2 / G1 over them, 0 where a ray would go below. */
    double reflected() {
        return mean((x, _, z) -> {
            double cosine = x * viewX + z * viewZ;
            double out = 2 * cosine * z - viewZ;
            return out > 0 ? (1 + lambda(viewZ)) / (1 + lambda(viewZ) + lambda(out)) : 0;
        });
    }

    /** q in [0, 1) of a normal. */
    double height(double z) {
        double tangentSquared = (1 - z * z) / (z * z);
        return Math.clamp(tangentSquared / (alpha * alpha + tangentSquared), 0, 1 - 1e-12);
    }

    private double lambda(double cosine) {
        return (Math.sqrt(1 + alpha * alpha * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
    }
}
