package dev.twister.scene.generate;

import dev.twister.scene.Rgb;
import java.util.List;

/** Smooth runs of colors. */
public enum Palette {
    /** From night blue through crimson to yellow. */
    DUSK(
            new Rgb(0.06, 0.07, 0.28),
            new Rgb(0.30, 0.10, 0.45),
            new Rgb(0.75, 0.15, 0.40),
            new Rgb(0.95, 0.42, 0.18),
            new Rgb(1.00, 0.82, 0.40)),
    /** From deep blue through green to sand. */
    LAGOON(
            new Rgb(0.02, 0.12, 0.30),
            new Rgb(0.02, 0.35, 0.50),
            new Rgb(0.10, 0.62, 0.58),
            new Rgb(0.55, 0.85, 0.60),
            new Rgb(0.98, 0.96, 0.75)),
    /** From leaf green through yellow to cherry red. */
    ORCHARD(
            new Rgb(0.10, 0.22, 0.08),
            new Rgb(0.28, 0.48, 0.12),
            new Rgb(0.80, 0.70, 0.15),
            new Rgb(0.88, 0.35, 0.10),
            new Rgb(0.62, 0.08, 0.10));

    public static final List<Palette> ALL = List.of(values());

    @SuppressWarnings("ImmutableEnumChecker") // a list of records, copied by List.of
    private final List<Rgb> stops;

    Palette(Rgb... stops) {
        this.stops = List.of(stops);
    }

    /** The color at a place in [0, 1], linear between stops. */
    Rgb at(double place) {
        double scaled = Math.clamp(place, 0, 1) * (stops.size() - 1);
        int low = Math.min((int) scaled, stops.size() - 2);
        return mix(stops.get(low), stops.get(low + 1), scaled - low);
    }

    /** {@code (1 - weight) * first + weight * second}. */
    static Rgb mix(Rgb first, Rgb second, double weight) {
        return new Rgb(
                first.red() + (second.red() - first.red()) * weight,
                first.green() + (second.green() - first.green()) * weight,
                first.blue() + (second.blue() - first.blue()) * weight);
    }
}
