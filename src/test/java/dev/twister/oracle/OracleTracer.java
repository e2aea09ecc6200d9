package dev.twister.oracle;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshPlacement;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.LongAdder;

/** Traces the color along a ray, recursively. */
final class OracleTracer {
    private static final double PERFECT_MIRROR = 128;

    /** In meters, beyond all bodies. */
    private static final double SUN_DISTANCE = 1e7;

    private static final Vector NEVER_HIT = new Vector(Double.NaN, 0, 0);

    /** Paths that transmit light end below this throughput. */
    private static final double LEAST_THROUGHPUT = 1.0 / 1024;

    private static final Color ALL = new Color(1, 1, 1);

    private final List<Body> bodies = new ArrayList<>();
    private final List<Lamp> lamps = new ArrayList<>();
    private final OracleShadow shadow;
    private final OracleSky sky;
    private final OracleMedia cameraMedia;
    private final double ambient;
    private final int bounceLimit;
    private final Rounding rounding;
    private final LongAdder followed = new LongAdder();

    /** A hit, shared by the branches of its ray. */
    private record Place(Ray ray, Body body, Vector point, Vector normal, boolean fromInside) {
        Vector toViewer() {
            return ray.direction().times(-1);
        }

        OracleMaterial material() {
            return body.material(point);
        }

        /** The normal on the viewer's side; the plane's own normal always points up. */
        Vector facing() {
            return ray.direction().dot(normal) > 0 ? normal.times(-1) : normal;
        }
    }

    /** A light and its share. */
    private record Lamp(SphereBody body, Light light) {
        /** A sun is as far away from each point, in the same direction. */
        SphereBody seenFrom(Vector point) {
            return light.isSun()
                    ? new SphereBody(
                            point.plus(vector(light.shape().toward()).times(SUN_DISTANCE)),
                            SUN_DISTANCE * light.shape().discSine(),
                            body.material())
                    : body;
        }

        double share() {
            return light.share();
        }
    }

    /** What lights do at a surface: lit, and the sum of the highlights. */
    private record Shading(double lit, Color highlight) {}

    OracleTracer(Scene scene, SceneImages images, SceneMeshes meshes, Rounding rounding) {
        this.rounding = rounding;
        bodies.addAll(bodies(scene, images, meshes));
        for (int index = 0; index < scene.lights().count(); index++) {
            SphereBody body = (SphereBody) bodies.get(lightNumber(scene, index));
            lamps.add(new Lamp(body, scene.lights().get(index)));
        }
        shadow = new OracleShadow(
                bodies.stream().filter(body -> !isLight(body)).toList(),
                scene.rendering().shadowSamples());
        sky = new OracleSky(
                images.sky(), scene.sky().rotationDegrees(), scene.sky().strength());
        cameraMedia = OracleMedia.around(vector(scene.camera().position()), bodies);
        ambient = scene.shading().ambient();
        bounceLimit = scene.rendering().bounces();
    }

    /** Returns the place of a light among {@link #bodies}. */
    static int lightNumber(Scene scene, int index) {
        return index == 0 ? 0 : 1 + scene.spheres().size() + index;
    }

    private static SphereBody body(Light light, SceneImages images) {
        return new SphereBody(
                light.isSun() ? NEVER_HIT : vector(light.position()),
                light.radius(),
                OracleMaterial.of(Material.DEFAULT.withColor(light.color()), images),
                light.shape());
    }

    /** Returns a scene's bodies: the first light, the plane, the spheres, the other lights and the triangles. */
    static List<Body> bodies(Scene scene, SceneImages images, SceneMeshes meshes) {
        List<Body> bodies = new ArrayList<>();
        bodies.add(body(scene.lights().first(), images));
        Ground plane = scene.ground();
        bodies.add(new PlaneBody(
                plane.size(), plane.height(), Color.of(plane.oddColor()), OracleMaterial.of(plane.material(), images)));
        for (Sphere sphere : scene.spheres()) {
            bodies.add(new SphereBody(
                    vector(sphere.position()), sphere.radius(), OracleMaterial.of(sphere.material(), images)));
        }
        for (Light light : scene.lights().list().subList(1, scene.lights().count())) {
            bodies.add(body(light, images));
        }
        int number = bodies.size();
        for (Mesh mesh : scene.meshes()) {
            Affine placement = MeshPlacement.of(mesh);
            for (MeshPart part : meshes.file(mesh).parts()) {
                TriangleMesh triangles = meshes.file(mesh).meshes().get(part.mesh());
                Material material = mesh.material().orElse(part.material());
                OracleMaterial made = OracleMaterial.of(
                        triangles.textureCoordinates().length == 0 ? material.withoutTexture() : material, images);
                OracleMaps maps = OracleMaps.of(
                        triangles.textureCoordinates().length == 0 ? material.withoutImages() : material, images);
                boolean colored = mesh.material().isEmpty();
                for (int triangle = 0; triangle < triangles.triangles(); triangle++) {
                    bodies.add(TriangleBody.of(
                            number, triangles, triangle, placement.of(part.placement()), made, maps, colored));
                }
                number++;
            }
        }
        return bodies;
    }

    /** Traces a view ray. */
    Color color(ViewRay viewRay) {
        return color(viewRay.ray(), Departure.CAMERA, cameraMedia, 0, ALL, viewRay.numbers());
    }

    /** Returns the value of a view, or of a stage at the first hit. Not thread-safe, as it counts bounces. */
    Color value(ViewRay viewRay, StageOrView picture) {
        Ray ray = viewRay.ray();
        Departure.Met met = Departure.CAMERA.closest(ray, bodies);
        Body body = met.body();
        if (picture == StageOrView.BOUNCES) {
            long before = followed.sum();
            color(viewRay);
            return ALL.times((double) (followed.sum() - before));
        }
        if (body == null) {
            return switch (picture) {
                case COLORS, DIFFUSE, HIGHLIGHTS -> sky.color(ray.direction());
                case SHADOW -> ALL;
                case BODY -> ALL.times(-1);
                default -> Color.BLACK;
            };
        }
        Place place = place(ray, body, ray.at(body.distance(ray)));
        Vector normal = place.normal();
        Color albedo = body.albedo(place.point());
        Shading unshadowed = shading(place, false);
        Color diffuse = isLight(body) ? albedo : albedo.times(unshadowed.lit());
        return switch (picture) {
            case COLORS, ALBEDO -> albedo;
            case DIFFUSE -> diffuse;
            case HIGHLIGHTS -> isLight(body) ? albedo : diffuse.plus(unshadowed.highlight());
            case NORMAL -> new Color(0.5 + 0.5 * normal.x(), 0.5 + 0.5 * normal.y(), 0.5 + 0.5 * normal.z());
            case DEPTH -> ALL.times(body.distance(ray));
            case BODY -> ALL.times(body instanceof TriangleBody triangle ? triangle.number() : bodies.indexOf(body));
            case SHADOW -> ALL.times(isLight(body) ? 1 : meanVisible(place));
            default -> throw new IllegalArgumentException(picture.id());
        };
    }

    /**
     * Traces a ray.
     *
     * @param media what it is in
     * @param throughput the ray's weight in the pixel
     */
    private Color color(
            Ray ray, Departure departure, OracleMedia media, int bounce, Color throughput, SampleNumbers numbers) {
        Departure.Met met = departure.closest(ray, bodies);
        Body body = met.body();
        if (body == null) {
            return sky.color(ray.direction());
        }
        double distance = met.distance();
        if (isLight(body)) {
            return body.material().color().times(media.passed(distance));
        }
        Place place = place(ray, body, ray.at(distance));
        OracleMedia here = media.at(body, place.fromInside());
        Color passed = here.passed(distance);
        return color(place, here, bounce, throughput.times(passed), numbers).times(passed);
    }

    /** Returns what leaves a surface toward the viewer. */
    private Color color(Place place, OracleMedia media, int bounce, Color throughput, SampleNumbers numbers) {
        Ray ray = place.ray();
        Body body = place.body();
        OracleMaterial material = place.material();
        Color albedo = body.albedo(place.point());
        double mirror = bounce < bounceLimit ? material.reflectivity() / PERFECT_MIRROR : 0;
        double transmission = bounce < bounceLimit ? material.transmission() : 0;
        Shading shading = shading(place, true);
        double lit = shading.lit();
        Color tint = material.tint(albedo);
        Color color = albedo.times((1 - mirror) * (1 - transmission) * lit).plus(tint.times(shading.highlight()));
        if (body.emits(ray, place.fromInside())) {
            color = color.plus(material.emission());
        }
        if (mirror == 0 && transmission == 0) {
            return color;
        }
        double passing = (1 - mirror) * transmission;
        Vector facet = facet(place, bounce, numbers);
        double cosine = Math.clamp(place.toViewer().dot(facet), 0, 1);
        double ratio = place.fromInside() && !material.thin() ? material.ior() : 1 / material.ior();
        double reflectance = passing > 0 ? Fresnel.reflectance(cosine, ratio) : 0;
        Vector reflected = ray.direction().plus(facet.times(2 * cosine)).normalized();
        Color reflectedPart = tint.times((mirror * lit + passing * reflectance) * weight(place, reflected, 1));
        color = color.plus(
                branch(place, reflected, place.fromInside(), media, reflectedPart, bounce, throughput, numbers));
        if (passing * (1 - reflectance) > 0) {
            boolean isSheet = body instanceof PlaneBody || material.thin();
            Vector passed = isSheet
                    ? reflected.minus(place.normal().times(2 * reflected.dot(place.normal())))
                    : Fresnel.refracted(ray.direction(), facet, ratio).normalized();
            Color passedPart =
                    body.passing(place.point()).times(passing * (1 - reflectance) * weight(place, passed, -1));
            boolean isInside = !(body instanceof PlaneBody) && !place.fromInside();
            OracleMedia behind = isSheet ? media : media.cross(body, isInside);
            color = color.plus(branch(place, passed, isInside, behind, passedPart, bounce, throughput, numbers));
        }
        return color;
    }

    private Shading shading(Place place, boolean shadowed) {
        double sum = 0;
        Color highlight = Color.BLACK;
        for (Lamp lamp : lamps) {
            SphereBody light = lamp.seenFrom(place.point());
            Vector toLight = light.center().minus(place.point()).normalized();
            double visible = shadowed ? shadow.visible(light, place.point(), place.body(), place.ray()) : 1;
            visible *= lamp.body().part(toLight);
            sum += lamp.share() * Math.max(0, place.normal().dot(toLight)) * visible;
            highlight = highlight.plus(light.material().color().times(highlight(place, toLight, visible)));
        }
        return new Shading(Math.max(ambient * place.body().open(place.point()), sum), highlight);
    }

    private double meanVisible(Place place) {
        return lamps.stream()
                .mapToDouble(
                        lamp -> shadow.visible(lamp.seenFrom(place.point()), place.point(), place.body(), place.ray()))
                .average()
                .orElseThrow();
    }

    @SuppressWarnings("ReferenceEquality") // compares identity of bodies
    private boolean isLight(Body body) {
        return lamps.stream().anyMatch(lamp -> lamp.body() == body);
    }

    /** Returns the weighted contribution of a secondary ray. */
    private Color branch(
            Place place,
            Vector direction,
            boolean inside,
            OracleMedia media,
            Color part,
            int bounce,
            Color throughput,
            SampleNumbers numbers) {
        Color rest = throughput.times(part);
        double least = place.material().transmits() ? rounding.cut() * LEAST_THROUGHPUT : 0;
        if (rest.strongest() == 0 || rest.strongest() < least) {
            return Color.BLACK;
        }
        followed.increment();
        Departure departure = new Departure(place.body(), inside, inside != place.fromInside());
        return color(new Ray(place.point(), direction), departure, media, bounce + 1, rest, numbers)
                .times(part);
    }

    private Place place(Ray ray, Body body, Vector surfacePoint) {
        Vector outward = body.normal(ray, surfacePoint);
        boolean fromInside = body.isMetFromInside(ray, outward);
        boolean turns = fromInside && body instanceof SphereBody;
        Vector point = body instanceof SphereBody sphere
                ? surfacePoint.plus(outward.times(rounding.lift() * sphere.radius()))
                : surfacePoint;
        return new Place(ray, body, point, turns ? outward.times(-1) : outward, fromInside);
    }

    /** Returns the normal for reflection and refraction. */
    private Vector facet(Place place, int bounce, SampleNumbers numbers) {
        double roughness = place.material().roughness();
        return roughness == 0
                ? place.facing()
                : RoughSurface.of(roughness)
                        .facet(
                                place.facing(),
                                place.toViewer(),
                                numbers.facetTurns(bounce),
                                numbers.facetHeight(bounce))
                        .plus(rounding.tilt())
                        .normalized();
    }

    /**
     * Returns the weight of light that a rough surface scatters at its facet.
     *
     * @param side 1 for reflection, -1 for transmission
     */
    private static double weight(Place place, Vector direction, int side) {
        double roughness = place.material().roughness();
        return roughness == 0
                ? 1
                : RoughSurface.of(roughness)
                        .weight(place.toViewer().dot(place.facing()), side * direction.dot(place.facing()));
    }

    /** The Blinn-Phong term, to be multiplied by the light's color. */
    private static double highlight(Place place, Vector toLight, double visible) {
        double p = place.material().reflectivity();
        Vector half = toLight.plus(place.toViewer()).normalized();
        return place.normal().dot(toLight) > 0
                ? visible
                        * (8 + p)
                        / (8 * Math.PI)
                        * Math.pow(Math.max(0, place.normal().dot(half)), p)
                        * p
                        / PERFECT_MIRROR
                : 0;
    }

    static Vector vector(Vector3 vector) {
        return new Vector(vector.x(), vector.y(), vector.z());
    }
}
