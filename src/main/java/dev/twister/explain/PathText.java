package dev.twister.explain;

import dev.twister.explain.PathStep.LightPart;
import dev.twister.explain.PathStep.LightSample;
import dev.twister.explain.PathStep.Scattering;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.kernel.Layout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A pixel's path for a person: a table of its steps, and what each surface is. */
public final class PathText {
    private static final List<String> TITLES = List.of(
            "step", "from", "ray", "meets", "distance", "N.L", "S", "lit", "spec", "m", "t", "F", "throughput", "adds");
    private static final int TEXTS = 4;

    private PathText() {}

    /** Lines that end with a line feed each. */
    public static String of(PixelPath path, BodyNames names) {
        return path.isTraced() ? TracedText.of(path, names) : whitted(path, names);
    }

    private static String whitted(PixelPath path, BodyNames names) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(TITLES);
        List<PathStep> steps = path.steps();
        for (int step = 0; step < steps.size(); step++) {
            rows.add(row(path, step, steps.get(step)));
        }
        StringBuilder text = new StringBuilder();
        text.append(String.format(
                Locale.ROOT,
                "Pixel %d,%d, sample %d of %d%n",
                path.column(),
                path.row(),
                path.sample(),
                path.samples()));
        PathStep view = steps.getFirst();
        text.append("View ray: from ")
                .append(TextTable.vector(view.origin()))
                .append(" along ")
                .append(TextTable.vector(view.direction()))
                .append("\n\n");
        text.append(TextTable.of(rows, TEXTS)).append('\n').append(names(path, names));
        for (int step = 0; step < steps.size(); step++) {
            int number = step;
            steps.get(step).shading().ifPresent(shading -> text.append(surface(path, number, shading)));
        }
        text.append(String.format(
                Locale.ROOT,
                "%nadds = throughput * ((1 - m) (1 - t) lit C + lightColor spec);"
                        + " light and sky add throughput * their radiance%n"));
        if (steps.stream().anyMatch(PathText::hasSeveralLights)) {
            text.append("lit = max(ambient, sum of k max(0, N.L) S); each light adds its own lightColor spec\n");
        }
        text.append(String.format(
                Locale.ROOT,
                "Sum of the steps: %s. Pixel: %s, shown as %d %d %d%n",
                TextTable.rgb(path.radiance()),
                TextTable.rgb(path.pixel()),
                path.shown(0),
                path.shown(1),
                path.shown(2)));
        return text.toString().replace(System.lineSeparator(), "\n");
    }

    private static List<String> row(PixelPath path, int number, PathStep step) {
        Optional<ShadedSurface> shading = step.shading();
        Optional<LightPart> light = shading.flatMap(ShadedSurface::onlyLight);
        return List.of(
                Integer.toString(number),
                step.parent() == PathStep.NO_PARENT ? "-" : Integer.toString(step.parent()),
                step.kind().id(),
                path.bodyName(step.body()),
                step.body() == Layout.NOTHING ? "-" : TextTable.number("%.3f m", step.distance()),
                cell(light.map(LightPart::normalDotLight)),
                cell(light.map(LightPart::visible)),
                cell(shading.map(ShadedSurface::lit)),
                cell(light.map(LightPart::specular)),
                cell(shading.map(ShadedSurface::mirror)),
                cell(shading.map(ShadedSurface::transmission)),
                cell(shading.map(ShadedSurface::reflectance)),
                TextTable.rgb(step.throughput()),
                TextTable.rgb(step.adds()));
    }

    private static boolean hasSeveralLights(PathStep step) {
        return step.shading().filter(shading -> shading.onlyLight().isEmpty()).isPresent();
    }

    private static String surface(PixelPath path, int step, ShadedSurface shading) {
        String lights = shading.onlyLight()
                .map(only -> "; " + shadow(path, only.shadowRays()) + "\n")
                .orElseGet(() -> shading.lights().stream()
                        .map(light -> light(path, step, light))
                        .collect(Collectors.joining("", "\n", "")));
        return String.format(
                Locale.ROOT,
                "step %d: point %s, N %s, C %s, p %s%s%s",
                step,
                TextTable.vector(shading.point()),
                TextTable.vector(shading.normal()),
                TextTable.rgb(shading.albedo()),
                TextTable.number("%.4g", shading.reflectivity()),
                shading.roughness() > 0 ? ", roughness " + TextTable.number("%.3f", shading.roughness()) : "",
                lights);
    }

    private static String light(PixelPath path, int step, LightPart light) {
        return String.format(
                Locale.ROOT,
                "step %d, light %d: N.L %s, S %s%s, k %s, adds %s to lit, spec %s; %s%n",
                step,
                light.light() + 1,
                TextTable.number("%.4f", light.normalDotLight()),
                TextTable.number("%.4f", light.visible()),
                light.cone() == 1 ? "" : ", cone " + TextTable.number("%.4f", light.cone()),
                TextTable.number("%.4g", light.share()),
                TextTable.number("%.4f", light.lit()),
                TextTable.number("%.4f", light.specular()),
                shadow(path, light.shadowRays()));
    }

    private static String shadow(PixelPath path, List<LightSample> rays) {
        if (rays.isEmpty()) {
            return "no shadow rays, as S would change nothing";
        }
        long free = rays.stream().filter(ray -> ray.light() == 1).count();
        Map<Integer, Long> blockers = rays.stream()
                .filter(ray -> ray.light() < 1)
                .collect(Collectors.groupingBy(LightSample::blocker, TreeMap::new, Collectors.counting()));
        return rays.size() + (rays.size() == 1 ? " shadow ray, " : " shadow rays, ") + free + " free"
                + blockers.entrySet().stream()
                        .map(entry ->
                                ", " + entry.getValue() + " stopped or dimmed by " + blocker(path, entry.getKey()))
                        .collect(Collectors.joining());
    }

    private static String blocker(PixelPath path, int body) {
        return body == Layout.NOTHING ? "an edge" : path.bodyName(body);
    }

    private static String cell(Optional<Double> value) {
        return value.map(number -> TextTable.number("%.4f", number)).orElse("-");
    }

    /** A line for each body that rays meet or are stopped by, and an empty line; empty where all miss. */
    static String names(PixelPath path, BodyNames names) {
        SortedSet<Integer> bodies =
                path.steps().stream().flatMap(PathText::bodies).collect(Collectors.toCollection(TreeSet::new));
        String lines = bodies.stream()
                .flatMap(body -> names.find(body).map(name -> nameLine(path.bodyName(body), name.text())).stream())
                .collect(Collectors.joining());
        return lines.isEmpty() ? "" : lines + "\n";
    }

    private static String nameLine(String body, String name) {
        return body.equals(name) ? "" : body + ": " + name + "\n";
    }

    private static Stream<Integer> bodies(PathStep step) {
        Stream<Integer> blockers = step.shading().stream()
                .flatMap(shading -> shading.lights().stream())
                .flatMap(light -> light.shadowRays().stream())
                .map(LightSample::blocker);
        Stream<Integer> emitter =
                step.scattering().flatMap(Scattering::emitter).stream().map(Scattering.EmitterChoice::body);
        return Stream.of(Stream.of(step.body()), blockers, emitter).flatMap(stream -> stream);
    }
}
