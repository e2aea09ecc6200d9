package dev.twister.explain;

import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The list of a path's bodies, with what the scene file says of them. */
final class NamesText {
    private NamesText() {}

    /** A line for each body that rays meet or are stopped by, and an empty line; empty where all miss. */
    static String of(PixelPath path, BodyNames names) {
        SortedSet<Integer> bodies =
                path.steps().stream().flatMap(NamesText::bodies).collect(Collectors.toCollection(TreeSet::new));
        String lines = bodies.stream()
                .flatMap(body -> names.find(body).map(name -> line(path.bodyName(body), name.text())).stream())
                .collect(Collectors.joining());
        return lines.isEmpty() ? "" : lines + "\n";
    }

    private static String line(String body, String name) {
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
