package dev.twister.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;

/** Builds the records that say how bodies move from their places in the file. */
final class MotionParts {
    private static final List<String> PHYSICS =
            List.of("gravity", "elasticity", "friction", "damping", "walls", "solidLight");
    private static final List<String> POUR =
            List.of("count", "rate", "position", "width", "speed", "radius", "palette", "reflectivity", "seed");
    private static final int SHOWN_DIGITS = 4;

    private MotionParts() {}

    static Physics physics(Place place) {
        Fields fields = place.fields().check(List.of(), PHYSICS);
        Physics silent = Physics.DEFAULT;
        return new Physics(
                fields.find("gravity")
                        .map(gravity -> gravity.vector(SceneLimits.GRAVITY))
                        .orElse(silent.gravity()),
                number(fields, "elasticity", SceneLimits.ELASTICITY, silent.elasticity()),
                number(fields, "friction", SceneLimits.FRICTION, silent.friction()),
                number(fields, "damping", SceneLimits.DAMPING, silent.damping()),
                fields.find("walls").map(Place::flag).orElse(silent.walls()),
                fields.find("solidLight").map(Place::flag).orElse(silent.solidLight()));
    }

    /**
     * Reads what is poured.
     *
     * @param placed how many spheres are there from the start: all together have a limit
     */
    static Pour pour(Place place, int placed) {
        Fields fields = place.fields().check(POUR);
        List<Double> radii = fields.get("radius")
                .items(2, 2, "an array of 2 numbers [least, most]", item -> item.number(SceneLimits.LENGTH));
        if (radii.getFirst() > radii.getLast()) {
            throw fields.get("radius").refused("an array of 2 numbers [least, most], the first not above the second");
        }
        Pour pour = new Pour(
                fields.get("count").wholeNumber(new Range(1, SceneLimits.MAX_SPHERES, "spheres")),
                fields.get("rate").number(SceneLimits.POUR_RATE),
                fields.get("position").vector(SceneLimits.POSITION),
                fields.get("width").number(SceneLimits.LENGTH),
                fields.get("speed").number(SceneLimits.POUR_SPEED),
                radii.getFirst(),
                radii.getLast(),
                PaletteNames.palette(fields.get("palette").oneOf(PaletteNames.ALL)),
                fields.get("reflectivity").number(SceneLimits.REFLECTIVITY),
                fields.get("seed").wholeNumber(SceneLimits.SEED));
        if (pour.count() > SceneLimits.MAX_SPHERES - placed) {
            throw fields.get("count")
                    .refused("at most " + (SceneLimits.MAX_SPHERES - placed) + ", which the " + placed
                            + " spheres of the scene leave of " + SceneLimits.MAX_SPHERES);
        }
        if (pour.rate() > pour.maxRate()) {
            throw fields.get("rate")
                    .refused("at most " + rounded(pour.maxRate())
                            + " for spheres of that radius, speed and width of the spout");
        }
        return pour;
    }

    private static double number(Fields fields, String name, Range range, double silent) {
        return fields.find(name).map(place -> place.number(range)).orElse(silent);
    }

    // Down, so that the number in the message is allowed.
    private static String rounded(double number) {
        return BigDecimal.valueOf(number)
                .round(new MathContext(SHOWN_DIGITS, RoundingMode.DOWN))
                .toPlainString();
    }
}
