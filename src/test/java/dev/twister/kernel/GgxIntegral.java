package dev.twister.kernel;

/**
 * GGX's distribution of visible normals by numerical integration, in a frame whose z is the surface normal and whose
 * view direction has y = 0. Normals are binned by azimuth and by q = tan^2 / (alpha^2 + tan^2) of their angle, in which
 * the distribution of all normals is uniform.
 */
final class GgxIntegral {
    private static final int HEIGHTS = 2000;
    private static final int AZIMUTHS = 240;

    private final double alpha;
    private final double viewX;
    private final double viewZ;

    /** Receives a normal and its share of the distribution. */
    @FunctionalInterface
    interface Visitor {
        void visit(double x, double y, double z, double share);
    }

    GgxIntegral(double roughness, double viewCosine) {
        alpha = roughness * roughness;
        viewX = Math.sqrt(1 - viewCosine * viewCosine);
        viewZ = viewCosine;
    }

    /** Visits normals that cover all visible ones. */
    void visit(Visitor visitor) {
        double first = 1 / (1 + lambda(viewZ));
        for (int height = 0; height < HEIGHTS; height++) {
            // Denser where normals are grazing and weigh most: 1 - q is a square.
            double root = 1 - (height + 0.5) / HEIGHTS;
            double q = 1 - root * root;
            double even = 2 * root * first / HEIGHTS / AZIMUTHS;
            double z = 1 / Math.sqrt(1 + alpha * alpha * q / (1 - q));
            double sine = Math.sqrt(1 - z * z);
            for (int azimuth = 0; azimuth < AZIMUTHS; azimuth++) {
                double angle = (azimuth + 0.5) * 2 * Math.PI / AZIMUTHS;
                double x = sine * Math.cos(angle);
                double cosine = x * viewX + z * viewZ;
                if (cosine > 0) {
                    visitor.visit(x, sine * Math.sin(angle), z, even * cosine / viewZ / z);
                }
            }
        }
    }

    /** Returns the reflected fraction of white light: the mean of G2 / G1, 0 for rays that would go below. */
    double reflected() {
        double[] sum = new double[1];
        visit((x, _, z, share) -> {
            double out = 2 * (x * viewX + z * viewZ) * z - viewZ;
            sum[0] += out > 0 ? share * (1 + lambda(viewZ)) / (1 + lambda(viewZ) + lambda(out)) : 0;
        });
        return sum[0];
    }

    /** Returns q in [0, 1) of a normal with this z. */
    double height(double z) {
        double tangentSquared = (1 - z * z) / (z * z);
        return Math.clamp(tangentSquared / (alpha * alpha + tangentSquared), 0, 1 - 1e-12);
    }

    private double lambda(double cosine) {
        return (Math.sqrt(1 + alpha * alpha * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
    }
}
