package dev.twister.explain;

import dev.twister.explain.PathStep.FoundLight;
import dev.twister.explain.PathStep.LightPart;
import dev.twister.explain.PathStep.LightSample;
import dev.twister.explain.PathStep.Scattering;
import dev.twister.explain.PathStep.Scattering.LobeChoice;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/** A pixel's path for programs, every number with all its digits. */
public final class PathJson {
    private PathJson() {}

    /** A JSON object; what a step has not, such as the surface of a ray that meets the sky, is absent. */
    public static String of(PixelPath path, BodyNames names) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("pixel", List.of(path.column(), path.row()));
        tree.put("sample", path.sample());
        tree.put("samples", path.samples());
        if (path.lights().size() > 1) {
            tree.put("lights", path.lights());
        }
        tree.put("steps", steps(path.steps(), names));
        tree.put("sampleRadiance", rgb(path.radiance()));
        tree.put("pixelRadiance", rgb(path.pixel()));
        tree.put("shown", List.of(path.shown(0), path.shown(1), path.shown(2)));
        return JsonMapper.builder()
                .enable(SerializationFeature.INDENT_OUTPUT)
                .build()
                .writeValueAsString(tree);
    }

    private static List<Map<String, Object>> steps(List<PathStep> steps, BodyNames names) {
        List<Map<String, Object>> list = new ArrayList<>();
        for (PathStep step : steps) {
            Map<String, Object> tree = new LinkedHashMap<>();
            tree.put("step", list.size());
            if (step.parent() != PathStep.NO_PARENT) {
                tree.put("parent", step.parent());
            }
            tree.put("ray", step.kind().id());
            tree.put("bounce", step.bounce());
            tree.put("origin", vector(step.origin()));
            tree.put("direction", vector(step.direction()));
            tree.put("inside", step.inside());
            tree.put("throughput", rgb(step.throughput()));
            tree.put("body", step.body());
            names.find(step.body()).ifPresent(name -> tree.put("meets", name.tree()));
            if (step.distance() != 0) {
                tree.put("distance", number(step.distance()));
            }
            step.shading().ifPresent(shading -> tree.put("surface", surface(shading)));
            step.light().ifPresent(light -> tree.put("light", light(light)));
            step.scattering().ifPresent(scattering -> tree.put("scattering", scattering(scattering)));
            tree.put("adds", rgb(step.adds()));
            list.add(tree);
        }
        return list;
    }

    private static Map<String, Object> light(FoundLight light) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("radiance", rgb(light.radiance()));
        tree.put("surfaceDensity", number(light.surfaceDensity()));
        tree.put("emitterDensity", number(light.emitterDensity()));
        tree.put("weight", number(light.weight()));
        return tree;
    }

    private static Map<String, Object> scattering(Scattering scattering) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("point", vector(scattering.point()));
        tree.put("normal", vector(scattering.normal()));
        tree.put("albedo", rgb(scattering.albedo()));
        tree.put("roughness", number(scattering.roughness()));
        tree.put("mirrorProbability", number(scattering.lobes().mirror()));
        tree.put("matteProbability", number(scattering.lobes().matte()));
        tree.put("glassProbability", number(scattering.lobes().glass()));
        tree.put("coatProbability", number(scattering.lobes().coat()));
        tree.put("throughProbability", number(scattering.lobes().through()));
        scattering.emitter().ifPresent(emitter -> {
            tree.put("emitter", emitter.body());
            tree.put("emitterProbability", number(emitter.probability()));
        });
        scattering.next().ifPresent(next -> tree.put("next", lobe(next)));
        return tree;
    }

    private static Map<String, Object> lobe(LobeChoice lobe) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("ray", lobe.kind().id());
        tree.put("probability", number(lobe.probability()));
        tree.put("surfaceDensity", number(lobe.density()));
        tree.put("factor", rgb(lobe.factor()));
        tree.put("survival", number(lobe.survival()));
        tree.put("goesOn", lobe.goesOn());
        return tree;
    }

    private static Map<String, Object> surface(ShadedSurface shading) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("point", vector(shading.point()));
        tree.put("normal", vector(shading.normal()));
        tree.put("albedo", rgb(shading.albedo()));
        tree.put("reflectivity", number(shading.reflectivity()));
        tree.put("roughness", number(shading.roughness()));
        if (shading.ior() > 0) {
            tree.put("ior", number(shading.ior()));
        }
        tree.put("lit", number(shading.lit()));
        tree.put("mirror", number(shading.mirror()));
        tree.put("transmission", number(shading.transmission()));
        tree.put("reflectance", number(shading.reflectance()));
        shading.onlyLight()
                .ifPresentOrElse(
                        light -> put(tree, light),
                        () -> tree.put(
                                "lights",
                                shading.lights().stream().map(PathJson::light).toList()));
        return tree;
    }

    private static Map<String, Object> light(LightPart light) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("light", light.light());
        put(tree, light);
        return tree;
    }

    private static void put(Map<String, Object> tree, LightPart light) {
        tree.put("toLight", vector(light.toLight()));
        tree.put("normalDotLight", number(light.normalDotLight()));
        tree.put("visible", number(light.visible()));
        if (light.cone() != 1) {
            tree.put("cone", number(light.cone()));
        }
        if (light.share() != 1) {
            tree.put("share", number(light.share()));
        }
        tree.put("specular", number(light.specular()));
        tree.put(
                "shadowRays",
                light.shadowRays().stream().map(PathJson::shadowRay).toList());
    }

    private static Map<String, Object> shadowRay(LightSample ray) {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("target", vector(ray.target()));
        tree.put("light", number(ray.light()));
        if (ray.blocker() != Layout.NOTHING) {
            tree.put("blocker", ray.blocker());
        }
        return tree;
    }

    private static List<Object> vector(Vector3 vector) {
        return List.of(number(vector.x()), number(vector.y()), number(vector.z()));
    }

    private static List<Object> rgb(Rgb color) {
        return List.of(number(color.red()), number(color.green()), number(color.blue()));
    }

    /** The kernel's floats by as few digits as tell them from one another. */
    private static Object number(double value) {
        float single = (float) value;
        if (single == value) {
            return single;
        }
        return value;
    }
}
