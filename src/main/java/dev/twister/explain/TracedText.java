package dev.twister.explain;

import dev.twister.explain.PathStep.FoundLight;
import dev.twister.explain.PathStep.RayKind;
import dev.twister.explain.PathStep.Scattering;
import dev.twister.explain.PathStep.Scattering.EmitterChoice;
import dev.twister.explain.PathStep.Scattering.LobeChoice;
import dev.twister.explain.PathStep.Scattering.LobeProbabilities;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** A path of path tracing for a person: a table of its rays, and the choices at each surface. */
final class TracedText {
    private static final List<String> TITLES = List.of(
            "step", "from", "ray", "meets", "distance", "p surface", "p light", "w", "throughput", "radiance", "adds");
    private static final int TEXTS = 4;

    private TracedText() {}

    /** Lines that end with a line feed each. */
    static String of(PixelPath path, BodyNames names) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(TITLES);
        StringBuilder surfaces = new StringBuilder();
        for (int step = 0; step < path.steps().size(); step++) {
            PathStep ray = path.steps().get(step);
            rows.add(row(path, step, ray));
            int number = step;
            ray.scattering().ifPresent(scattering -> surfaces.append(surface(path, number, scattering)));
        }
        PathStep view = path.steps().getFirst();
        return String.format(
                                Locale.ROOT,
                                "Pixel %d,%d, sample %d of %d, path tracing%nView ray: from %s along %s%n%n",
                                path.column(),
                                path.row(),
                                path.sample(),
                                path.samples(),
                                TextTable.vector(view.origin()),
                                TextTable.vector(view.direction()))
                        .replace(System.lineSeparator(), "\n")
                + TextTable.of(rows, TEXTS)
                + "\n"
                + PathText.names(path, names)
                + surfaces
                + "\nadds = throughput * w * radiance, clamped beyond the first surface; 0 if the way to an emitter is"
                + " blocked\n"
                + String.format(
                        Locale.ROOT,
                        "Sum of the steps: %s. Pixel, the mean of %d samples: %s, shown as %d %d %d\n",
                        TextTable.rgb(path.radiance()),
                        path.samples(),
                        TextTable.rgb(path.pixel()),
                        path.shown(0),
                        path.shown(1),
                        path.shown(2));
    }

    private static List<String> row(PixelPath path, int number, PathStep step) {
        Optional<FoundLight> light = step.light();
        return List.of(
                Integer.toString(number),
                step.parent() == PathStep.NO_PARENT ? "-" : Integer.toString(step.parent()),
                step.kind().id(),
                path.bodyName(step.body()),
                step.distance() == 0 ? "-" : TextTable.number("%.3f m", step.distance()),
                light.map(found -> density(found.surfaceDensity())).orElse("-"),
                light.map(found -> density(found.emitterDensity())).orElse("-"),
                light.map(found -> TextTable.number("%.4f", found.weight())).orElse("-"),
                TextTable.rgb(step.throughput()),
                light.map(found -> TextTable.rgb(found.radiance())).orElse("-"),
                TextTable.rgb(step.adds()));
    }

    private static String surface(PixelPath path, int step, Scattering surface) {
        return String.format(
                        Locale.ROOT,
                        "step %d: point %s, N %s, C %s%s; lobes: %s",
                        step,
                        TextTable.vector(surface.point()),
                        TextTable.vector(surface.normal()),
                        TextTable.rgb(surface.albedo()),
                        surface.roughness() > 0 ? ", roughness " + TextTable.number("%.3f", surface.roughness()) : "",
                        lobes(surface.lobes()))
                + surface.emitter()
                        .map(chosen -> emitter(path, chosen, isAimedAt(path, step)))
                        .orElse("")
                + surface.next().map(TracedText::lobe).orElse("\n        the last bounce: no ray is scattered")
                + "\n";
    }

    /** Those of finishes are named where there are any. */
    private static String lobes(LobeProbabilities lobes) {
        return "mirror " + probability(lobes.mirror())
                + ", matte " + probability(lobes.matte())
                + ", glass " + probability(lobes.glass())
                + (lobes.coat() > 0 ? ", clear coat " + probability(lobes.coat()) : "")
                + (lobes.through() > 0 ? ", diffuse transmission " + probability(lobes.through()) : "");
    }

    private static boolean isAimedAt(PixelPath path, int step) {
        return path.steps().stream().anyMatch(ray -> ray.kind() == RayKind.EMITTER && ray.parent() == step);
    }

    private static String emitter(PixelPath path, EmitterChoice emitter, boolean aimedAt) {
        return "\n        chose emitter " + path.bodyName(emitter.body()) + " with probability "
                + probability(emitter.probability()) + (aimedAt ? "" : "; no light from the chosen direction");
    }

    private static String lobe(LobeChoice lobe) {
        return "\n        chose a " + lobe.kind().id() + " ray with probability " + probability(lobe.probability())
                + ", p surface " + density(lobe.density()) + "; throughput * " + TextTable.rgb(lobe.factor())
                + roulette(lobe);
    }

    private static String roulette(LobeChoice lobe) {
        if (lobe.survival() == 1) {
            return lobe.goesOn() ? "" : "; the path ends";
        }
        return "; Russian roulette: "
                + (lobe.goesOn() ? "goes on with probability " : "ended, went on with probability ")
                + probability(lobe.survival());
    }

    private static String density(double density) {
        return density == 0 ? "-" : TextTable.number("%.4g", density);
    }

    private static String probability(double probability) {
        return TextTable.number("%.4f", probability);
    }
}
