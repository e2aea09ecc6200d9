package dev.twister.explain;

import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** A pixel's path for a person: a table of its steps, and what each surface is. */
public final class PathText {
    private static final List<String> TITLES = List.of(
            "step", "from", "ray", "meets", "distance", "N.L", "S", "lit", "spec", "m", "t", "F", "throughput", "adds");
    private static final int TEXTS = 4;
    private static final String GAP = "  ";

    private PathText() {}

    /** Lines that end with a line feed each. */
    public static String of(PixelPath path) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(TITLES);
        List<PathStep> steps = path.steps();
        for (int step = 0; step < steps.size(); step++) {
            rows.add(row(step, steps.get(step)));
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
                .append(vector(view.origin()))
                .append(" along ")
                .append(vector(view.direction()))
                .append("\n\n");
        text.append(table(rows));
        text.append('\n');
        for (int step = 0; step < steps.size(); step++) {
            int number = step;
            steps.get(step).shading().ifPresent(shading -> text.append(surface(number, shading)));
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
                rgb(path.radiance()),
                rgb(path.pixel()),
                path.shown(0),
                path.shown(1),
                path.shown(2)));
        return text.toString().replace(System.lineSeparator(), "\n");
    }

    private static List<String> row(int number, PathStep step) {
        Optional<ShadedSurface> shading = step.shading();
        Optional<LightPart> light = shading.flatMap(ShadedSurface::onlyLight);
        return List.of(
                Integer.toString(number),
                step.parent() == PathStep.NO_PARENT ? "-" : Integer.toString(step.parent()),
                step.kind().id(),
                step.meets(),
                step.body() == Layout.NOTHING ? "-" : number("%.3f m", step.distance()),
                cell(light.map(LightPart::normalDotLight)),
                cell(light.map(LightPart::visible)),
                cell(shading.map(ShadedSurface::lit)),
                cell(light.map(LightPart::specular)),
                cell(shading.map(ShadedSurface::mirror)),
                cell(shading.map(ShadedSurface::transmission)),
                cell(shading.map(ShadedSurface::reflectance)),
                rgb(step.throughput()),
                rgb(step.adds()));
    }

    private static String table(List<List<String>> rows) {
        int[] widths = IntStream.range(0, TITLES.size())
                .map(column -> rows.stream()
                        .mapToInt(row -> row.get(column).length())
                        .max()
                        .orElse(0))
                .toArray();
        return rows.stream()
                .map(row -> IntStream.range(0, widths.length)
                        .mapToObj(column -> padded(row.get(column), widths[column], column))
                        .collect(Collectors.joining(GAP, "", "\n")))
                .collect(Collectors.joining());
    }

    private static String padded(String text, int width, int column) {
        String spaces = " ".repeat(width - text.length());
        return column < TEXTS ? text + spaces : spaces + text;
    }

    private static boolean hasSeveralLights(PathStep step) {
        return step.shading().filter(shading -> shading.onlyLight().isEmpty()).isPresent();
    }

    private static String surface(int step, ShadedSurface shading) {
        String lights = shading.onlyLight()
                .map(only -> "; " + shadow(only.shadowRays()) + "\n")
                .orElseGet(() -> shading.lights().stream()
                        .map(light -> light(step, light))
                        .collect(Collectors.joining("", "\n", "")));
        return String.format(
                Locale.ROOT,
                "step %d: point %s, N %s, C %s, p %s%s%s",
                step,
                vector(shading.point()),
                vector(shading.normal()),
                rgb(shading.albedo()),
                number("%.4g", shading.reflectivity()),
                shading.roughness() > 0 ? ", roughness " + number("%.3f", shading.roughness()) : "",
                lights);
    }

    private static String light(int step, LightPart light) {
        return String.format(
                Locale.ROOT,
                "step %d, light %d: N.L %s, S %s, k %s, adds %s to lit, spec %s; %s%n",
                step,
                light.light() + 1,
                number("%.4f", light.normalDotLight()),
                number("%.4f", light.visible()),
                number("%.4g", light.share()),
                number("%.4f", light.lit()),
                number("%.4f", light.specular()),
                shadow(light.shadowRays()));
    }

    private static String shadow(List<LightSample> rays) {
        if (rays.isEmpty()) {
            return "no shadow rays, as S would change nothing";
        }
        long free = rays.stream().filter(ray -> ray.light() == 1).count();
        Map<Integer, Long> blockers = rays.stream()
                .filter(ray -> ray.light() < 1)
                .collect(Collectors.groupingBy(LightSample::blocker, TreeMap::new, Collectors.counting()));
        return rays.size() + (rays.size() == 1 ? " shadow ray, " : " shadow rays, ") + free + " free"
                + blockers.entrySet().stream()
                        .map(entry -> ", " + entry.getValue() + " stopped or dimmed by " + blocker(entry.getKey()))
                        .collect(Collectors.joining());
    }

    private static String blocker(int body) {
        return body == Layout.NOTHING ? "an edge" : PathStep.bodyName(body);
    }

    private static String cell(Optional<Double> value) {
        return value.map(number -> number("%.4f", number)).orElse("-");
    }

    private static String vector(Vector3 vector) {
        return number("(%.3f", vector.x()) + number(", %.3f", vector.y()) + number(", %.3f)", vector.z());
    }

    private static String rgb(Rgb color) {
        return number("%.5f", color.red()) + number(" %.5f", color.green()) + number(" %.5f", color.blue());
    }

    private static String number(String format, double value) {
        // Without the sign of a zero, which says nothing here.
        return String.format(Locale.ROOT, format, value + 0.0);
    }
}
