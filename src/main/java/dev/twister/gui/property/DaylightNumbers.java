package dev.twister.gui.property;

import dev.twister.gui.property.NumberScale.Spread;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Range;
import dev.twister.sky.Daylight;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;

/** The numbers of a daylight sky; any change of one makes such a sky the scene's. */
public final class DaylightNumbers {
    public static final List<NumberProperty<Scene>> ALL = List.of(
            number(
                    "Sun height",
                    "Makes a daylight sky: the sun's height over the horizon.",
                    new NumberScale(degrees(0, Daylight.MAX_ELEVATION_DEGREES), degrees(0, 90), Spread.LINEAR, 0, "°"),
                    DaylightFile::height,
                    DaylightFile::withHeight),
            number(
                    "Sun direction",
                    "Makes a daylight sky: 0 is ahead, 90 to the right.",
                    new NumberScale(degrees(-180, 180), degrees(-180, 180), Spread.LINEAR, 0, "°"),
                    DaylightFile::direction,
                    DaylightFile::withDirection),
            number(
                    "Haze",
                    "Makes a daylight sky: 2 is very clear, 3 clear, 6 hazy, 10 nearly fog.",
                    new NumberScale(haze(), haze(), Spread.LINEAR, 1, ""),
                    DaylightFile::haze,
                    DaylightFile::withHaze),
            number(
                    "Clouds",
                    "Makes a daylight sky: 0 is clear, 1 an even layer of clouds.",
                    new NumberScale(new Range(0, 1), new Range(0, 1), Spread.LINEAR, 2, ""),
                    DaylightFile::clouds,
                    DaylightFile::withClouds));

    private DaylightNumbers() {}

    private static Range degrees(double least, double most) {
        return new Range(least, most, "degrees");
    }

    private static Range haze() {
        return new Range(Daylight.MIN_TURBIDITY, Daylight.MAX_TURBIDITY);
    }

    private static NumberProperty<Scene> number(
            String label,
            String hint,
            NumberScale scale,
            ToDoubleFunction<DaylightFile> getter,
            BiFunction<DaylightFile, Double, DaylightFile> wither) {
        return new NumberProperty<>(
                label,
                hint,
                "",
                scale,
                scene -> getter.applyAsDouble(DaylightFile.of(scene)),
                (scene, number) -> wither.apply(DaylightFile.of(scene), number).in(scene));
    }
}
