package dev.twister.oracle;

import dev.twister.scene.Light;
import dev.twister.scene.Plane;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import java.util.ArrayList;
import java.util.List;

/** The colour that a ray sees, by recursion. */
final class OracleTracer {
    private static final double PERFECT_MIRROR = 128;

    private final List<Body> bodies = new ArrayList<>();
    private final SphereBody light;
    private final OracleShadow shadow;
    private final OracleSky sky;
    private final double ambient;
    private final int bounceLimit;
    private final double lift;

    OracleTracer(Scene scene, Skybox skybox) {
        this(scene, skybox, 0);
    }

    /**
     * A tracer whose points on spheres are off the surface, as rounding has them.
     *
     * @param lift how far outwards, in radii; the true picture's is 0
     */
    OracleTracer(Scene scene, Skybox skybox, double lift) {
        this.lift = lift;
        Light sceneLight = scene.light();
        light = new SphereBody(vector(sceneLight.position()), sceneLight.radius(), Color.of(sceneLight.color()), 0);
        Plane plane = scene.plane();
        bodies.add(light);
        bodies.add(new PlaneBody(
                plane.size(),
                plane.height(),
                Color.of(plane.evenColor()),
                Color.of(plane.oddColor()),
                plane.reflectivity()));
        for (Sphere sphere : scene.spheres()) {
            bodies.add(new SphereBody(
                    vector(sphere.position()), sphere.radius(), Color.of(sphere.color()), sphere.reflectivity()));
        }
        shadow = new OracleShadow(bodies, light, scene.settings().shadowSamples());
        sky = new OracleSky(skybox, scene.skyRotationDegrees(), scene.skyStrength());
        ambient = scene.ambient();
        bounceLimit = scene.settings().bounces();
    }

    /** What a view ray sees. */
    Color color(Ray viewRay) {
        return color(viewRay, null, 0);
    }

    /** color(bounce), seen along a ray that leaves a body; a view ray leaves none (null). */
    @SuppressWarnings("ReferenceEquality") // which body it is, not what it is like
    private Color color(Ray ray, Body leaving, int bounce) {
        Body body = closest(ray, leaving);
        if (body == null) {
            return sky.color(ray.direction());
        }
        if (body == light) {
            return light.color();
        }
        Vector surfacePoint = ray.at(body.distance(ray));
        Vector normal = body.normal(surfacePoint);
        Vector point = body instanceof SphereBody sphere
                ? surfacePoint.plus(normal.times(lift * sphere.radius()))
                : surfacePoint;
        double mirror = bounce < bounceLimit ? body.reflectivity() / PERFECT_MIRROR : 0;
        Color base = body.albedo(point).times(1 - mirror);
        if (mirror > 0) {
            base = base.plus(
                    color(reflected(ray, point, normal), body, bounce + 1).times(mirror));
        }
        return shade(base, body, point, normal, ray);
    }

    /** The lower index on a tie, null where there is none. */
    @SuppressWarnings("ReferenceEquality") // which body it is, not what it is like
    private Body closest(Ray ray, Body leaving) {
        Body closest = null;
        double closestDistance = Body.MISS;
        for (Body body : bodies) {
            if (body != leaving) {
                double distance = body.distance(ray);
                if (distance < closestDistance) {
                    closest = body;
                    closestDistance = distance;
                }
            }
        }
        return closest;
    }

    private static Ray reflected(Ray ray, Vector point, Vector normal) {
        Vector direction = ray.direction();
        return new Ray(
                point, direction.minus(normal.times(2 * direction.dot(normal))).normalized());
    }

    /** Blinn-Phong: {@code shade(C) = C * lit + lightColor * spec}. */
    private Color shade(Color base, Body body, Vector point, Vector normal, Ray ray) {
        Vector toLight = light.center().minus(point).normalized();
        Vector toViewer = ray.direction().times(-1);
        Vector half = toLight.plus(toViewer).normalized();
        double normalDotLight = normal.dot(toLight);
        double visible = shadow.visible(point, body);
        double p = body.reflectivity();
        double lit = Math.max(ambient, Math.max(0, normalDotLight) * visible);
        double specular = normalDotLight > 0
                ? visible * (8 + p) / (8 * Math.PI) * Math.pow(Math.max(0, normal.dot(half)), p) * p / PERFECT_MIRROR
                : 0;
        return base.times(lit).plus(light.color().times(specular));
    }

    private static Vector vector(Vector3 vector) {
        return new Vector(vector.x(), vector.y(), vector.z());
    }
}
