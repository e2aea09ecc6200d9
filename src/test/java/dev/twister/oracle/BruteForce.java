package dev.twister.oracle;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/**
 * Path tracing in double precision without any means against noise: rays leave surfaces at random, and light counts
 * where a ray meets it. Slow, and simple enough to be seen to be right.
 */
final class BruteForce {
    private static final double PERFECT_MIRROR = 128;
    private static final Color ONE = new Color(1, 1, 1);

    private final List<Body> bodies;
    private final Set<Body> lights;
    private final OracleSky sky;
    private final int bounceLimit;
    private final Random random;
    private final Map<List<Double>, Energy> energies = new HashMap<>();

    /**
     * @param bodies with the lights' radiance as emission
     * @param lights those among the bodies that end paths
     * @param bounceLimit number of surfaces between the first one and the one at which a path ends, but for the light
     *     that it meets from there
     */
    BruteForce(List<Body> bodies, Set<Body> lights, OracleSky sky, int bounceLimit, Random random) {
        this.bodies = bodies;
        this.lights = lights;
        this.sky = sky;
        this.bounceLimit = bounceLimit;
        this.random = random;
    }

    /** What a surface does with a ray: where it goes, and what part of the light comes from there. */
    private record Scattered(Vector direction, Color part, boolean inside) {}

    /** Returns the radiance along a view ray, by one path. */
    Color color(Ray view) {
        Ray ray = view;
        Color throughput = new Color(1, 1, 1);
        Color found = Color.BLACK;
        Departure departure = Departure.CAMERA;
        OracleMedia media = OracleMedia.around(view.origin(), bodies);
        for (int bounce = 0; throughput.strongest() > 0; bounce++) {
            Departure.Met met = departure.closest(ray, bodies);
            Body body = met.body();
            if (body == null) {
                return found.plus(throughput.times(sky.color(ray.direction())));
            }
            double distance = met.distance();
            Vector point = ray.at(distance);
            Vector normal = body.normal(ray, point);
            boolean fromInside = body.isMetFromInside(ray, normal);
            OracleMaterial material = body.material(point);
            media = media.at(body, fromInside);
            throughput = throughput.times(media.passed(distance));
            if (body.emits(ray, fromInside)) {
                Color emitted = material.emission().times(body.part(ray.direction()));
                found = found.plus(throughput.times(emitted).times(media.spread()));
            }
            if (lights.contains(body) || bounce > bounceLimit) {
                return found;
            }
            Vector facing = ray.direction().dot(normal) > 0 ? normal.times(-1) : normal;
            Scattered next = scatter(body, material, body.albedo(point), ray.direction(), facing, fromInside);
            Vector face = body.face(ray, point);
            boolean passes = next.inside() != fromInside || next.direction().dot(facing) < 0;
            boolean right = next.direction().dot(face) > 0 != passes;
            throughput = right ? throughput.times(next.part()) : Color.BLACK;
            ray = new Ray(point, next.direction());
            boolean crossed = next.inside() != fromInside;
            departure = new Departure(body, next.inside(), crossed);
            media = crossed ? media.cross(body, next.inside()) : media;
        }
        return found;
    }

    /** Chooses a lobe in proportion to its strongest channel, and a direction as that lobe scatters. */
    private Scattered scatter(
            Body body, OracleMaterial material, Color albedo, Vector direction, Vector normal, boolean fromInside) {
        Vector toViewer = direction.times(-1);
        boolean within = fromInside && !material.thin();
        boolean isSheet = body instanceof PlaneBody || material.thin();
        double ratio = within ? material.ior() : 1 / material.ior();
        boolean rough = material.roughness() > 0;
        RoughSurface facets = RoughSurface.of(material.roughness());
        Vector facet = rough ? facets.facet(normal, toViewer, random.nextDouble(), random.nextDouble()) : normal;
        double cosine = Math.clamp(toViewer.dot(facet), 0, 1);
        boolean byFresnel = material.byFresnel();
        double mirror = material.besideReflectivity() / PERFECT_MIRROR;
        double constant = byFresnel
                ? material.metallic()
                : material.besideMetal()
                        ? material.metallic() + (1 - material.metallic()) * mirror
                        : material.reflectivity() / PERFECT_MIRROR;
        Energy energy = byFresnel ? energy(material, within) : null;
        double whole = 1;
        if (byFresnel && rough) {
            RoughAlbedo all = isSheet ? energy.mirror() : energy.glass();
            whole = 1 / all.of(toViewer.dot(normal));
        }
        double glassy = (1 - constant) * material.transmission() * whole;
        double coats = within ? 0 : 1 - material.transmission();
        double coat = byFresnel ? (1 - constant) * coats + glassy : glassy;
        double fresnel = coat > 0 ? Fresnel.reflectance(cosine, ratio) : 0;
        Color metal = byFresnel ? schlick(albedo, cosine) : material.tint(albedo);
        Color reflection = material.besideMetal()
                ? schlick(albedo, cosine).times(material.metallic()).plus(ONE.times((1 - material.metallic()) * mirror))
                : metal.times(constant);
        Color mirrored = reflection.plus(ONE.times(coat * fresnel));
        Color passed = albedo.times(glassy * (1 - fresnel));
        Color matte = albedo.times((1 - constant) * (1 - material.transmission()));
        Color again = byFresnel ? energy.again(albedo).times(constant) : Color.BLACK;
        double diffuse = matte.strongest() + again.strongest();
        double sum = mirrored.strongest() + passed.strongest() + diffuse;
        double choice = random.nextDouble() * sum;
        Vector reflected = direction.plus(facet.times(2 * cosine)).normalized();
        if (choice < mirrored.strongest()) {
            double weight = rough ? facets.weight(toViewer.dot(normal), reflected.dot(normal)) : 1;
            return new Scattered(reflected, mirrored.times(weight * sum / mirrored.strongest()), fromInside);
        }
        if (choice < mirrored.strongest() + passed.strongest()) {
            Vector out = isSheet
                    ? reflected.minus(normal.times(2 * reflected.dot(normal)))
                    : Fresnel.refracted(direction, facet, ratio).normalized();
            double weight = rough ? facets.weight(toViewer.dot(normal), -out.dot(normal)) : 1;
            boolean inside = body instanceof PlaneBody ? fromInside : !fromInside;
            return new Scattered(out, passed.times(weight * sum / passed.strongest()), inside);
        }
        Vector out = cosineDistributed(normal);
        if (byFresnel) {
            double in = toViewer.dot(normal);
            matte = within ? matte : matte.times(left(energy.coat(), in, out.dot(normal)));
            again = again.times(left(energy.mirror(), in, out.dot(normal)));
        }
        return new Scattered(out, matte.plus(again).times(sum / diffuse), fromInside);
    }

    /** What is left beside a reflection, in both directions: without loss, and reciprocal. */
    private static double left(RoughAlbedo reflected, double cosineIn, double cosineOut) {
        return (1 - reflected.of(cosineIn)) * (1 - reflected.of(cosineOut)) / Math.max(1e-9, 1 - reflected.mean());
    }

    private Energy energy(OracleMaterial material, boolean fromInside) {
        double ratio = fromInside ? material.ior() : 1 / material.ior();
        return energies.computeIfAbsent(
                List.of(material.roughness(), ratio),
                _ -> new Energy(
                        RoughAlbedo.ofMirror(material.roughness()),
                        RoughAlbedo.ofCoat(material.roughness(), ratio),
                        RoughAlbedo.ofGlass(material.roughness(), ratio)));
    }

    /** What a rough surface scatters once. */
    private record Energy(RoughAlbedo mirror, RoughAlbedo coat, RoughAlbedo glass) {
        /** The color of what a metal scatters more than once (Kulla and Conty 2017). */
        Color again(Color albedo) {
            return new Color(again(albedo.red()), again(albedo.green()), again(albedo.blue()));
        }

        private double again(double albedo) {
            // Schlick's term in the mean.
            double reflected = albedo + (1 - albedo) / 21;
            return reflected * reflected * mirror.mean() / (1 - reflected * (1 - mirror.mean()));
        }
    }

    private static Color schlick(Color albedo, double cosine) {
        return albedo.plus(ONE.plus(albedo.times(-1)).times(Math.pow(1 - cosine, 5)));
    }

    /**
     * A direction about the normal with a density proportional to its cosine: a point of the sphere at the normal's
     * tip.
     */
    private Vector cosineDistributed(Vector normal) {
        double z = 2 * random.nextDouble() - 1;
        double turn = 2 * Math.PI * random.nextDouble();
        double level = Math.sqrt(1 - z * z);
        return normal.plus(new Vector(level * Math.cos(turn), level * Math.sin(turn), z))
                .normalized();
    }
}
