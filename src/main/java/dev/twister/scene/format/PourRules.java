package dev.twister.scene.format;

import dev.twister.scene.SceneException;
import dev.twister.scene.generate.Pour;
import dev.twister.scene.property.SceneLimits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** What the fields of a pour have to be to each other, and to the spheres beside it. */
final class PourRules {
    private static final int SHOWN_DIGITS = 4;

    private PourRules() {}

    /**
     * @param fields the pour's, in the file
     * @param placed how many spheres are there from the start: all together have a limit
     * @throws SceneException if a rule is broken
     */
    static void check(Pour pour, Fields fields, int placed) {
        if (pour.minRadius() > pour.maxRadius()) {
            throw fields.get("radius").refused("an array of 2 numbers [least, most], the first not above the second");
        }
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
    }

    // Down, so that the number in the message is allowed.
    private static String rounded(double number) {
        return BigDecimal.valueOf(number)
                .round(new MathContext(SHOWN_DIGITS, RoundingMode.DOWN))
                .toPlainString();
    }
}
