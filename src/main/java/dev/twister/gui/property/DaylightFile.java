package dev.twister.gui.property;

import dev.twister.image.HdrWriter;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Copied;
import dev.twister.scene.property.Range;
import dev.twister.scene.property.Slide;
import dev.twister.sky.Daylight;
import dev.twister.sky.DaylightSky;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.Skybox;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A daylight sky whose parameters are in the name of its file, such as {@code daylight_42_-140_3_0.hdr}: it is drawn
 * where the file is missing, and written with the scene.
 *
 * @param height of the sun, in degrees
 * @param direction of the sun, in degrees to the right of +z
 * @param haze turbidity, see {@link Daylight}
 * @param clouds cloud cover, 0 to 1
 */
@Copied
public record DaylightFile(double height, double direction, double haze, double clouds)
        implements DaylightFileCopy.With {
    /** What a name does not tell is as {@code twister sky} has it. */
    private static final Daylight DAY = ShippedSky.DAY.daylight();

    public static final DaylightFile USUAL =
            new DaylightFile(DAY.sunElevationDegrees(), DAY.sunAzimuthDegrees(), DAY.turbidity(), DAY.cloudCover());

    private static final String NUMBER = "_(-?[0-9]{1,3}(?:\\.[0-9]{1,3})?)";
    private static final Pattern NAME = Pattern.compile("daylight" + NUMBER.repeat(4) + "\\.hdr");

    /** The panel's rows; any change of one makes such a sky the scene's. */
    public static final List<NumberProperty<Scene>> NUMBERS = List.of(
            number(
                    "Sun height",
                    "Makes a daylight sky: the sun's height over the horizon.",
                    new NumberScale(degrees(0, Daylight.MAX_ELEVATION_DEGREES), Slide.linear(0, 90, 0, "°")),
                    DaylightFile::height,
                    DaylightFile::withHeight),
            number(
                    "Sun direction",
                    "Makes a daylight sky: 0 is ahead, 90 to the right.",
                    new NumberScale(degrees(-180, 180), Slide.linear(-180, 180, 0, "°")),
                    DaylightFile::direction,
                    DaylightFile::withDirection),
            number(
                    "Haze",
                    "Makes a daylight sky: 2 is very clear, 3 clear, 6 hazy, 10 nearly fog.",
                    new NumberScale(
                            new Range(Daylight.MIN_TURBIDITY, Daylight.MAX_TURBIDITY),
                            Slide.linear(Daylight.MIN_TURBIDITY, Daylight.MAX_TURBIDITY, 1, "")),
                    DaylightFile::haze,
                    DaylightFile::withHaze),
            number(
                    "Clouds",
                    "Makes a daylight sky: 0 is clear, 1 an even layer of clouds.",
                    new NumberScale(new Range(0, 1), Slide.SHARE),
                    DaylightFile::clouds,
                    DaylightFile::withClouds));

    /** The parameters in a file's name; empty if it is another one. */
    public static Optional<DaylightFile> of(Path file) {
        Matcher name = NAME.matcher(String.valueOf(file.getFileName()));
        return Optional.of(name)
                .filter(Matcher::matches)
                .map(found -> new DaylightFile(number(found, 1), number(found, 2), number(found, 3), number(found, 4)))
                .filter(DaylightFile::isPossible);
    }

    /** Those of a scene's sky, or the usual ones if that is no such sky. */
    public static DaylightFile of(Scene scene) {
        return of(scene.sky().file()).orElse(USUAL);
    }

    /** The scene with this sky, in the folder of its present one. */
    public Scene in(Scene scene) {
        return scene.withSky(scene.sky().withFile(scene.sky().file().resolveSibling(name())));
    }

    /** The scene with its sky in the folder of a scene's file, if it is such a sky. */
    public static Scene movedBeside(Path sceneFile, Scene scene) {
        return of(scene.sky().file())
                .map(sky -> scene.withSky(
                        scene.sky().withFile(sceneFile.toAbsolutePath().resolveSibling(sky.name()))))
                .orElse(scene);
    }

    /**
     * Writes the sky of a scene, if it is such a sky and its file is missing.
     *
     * @throws IOException if it cannot be written
     */
    public static void writeIfMissing(Scene scene) throws IOException {
        Path file = scene.sky().file();
        Optional<DaylightFile> missing = of(file).filter(_ -> !Files.exists(file));
        if (missing.isPresent()) {
            Skybox sky = missing.get().draw();
            HdrWriter.write(file, sky.width(), sky.height(), sky.radiance());
        }
    }

    /** Draws the panorama, without the sun's disc. */
    public Skybox draw() {
        return DaylightSky.panorama(
                ShippedSky.WIDTH,
                ShippedSky.HEIGHT,
                new Daylight(height, direction, haze, clouds, DAY.groundAlbedo(), DAY.meanSkyRadiance(), false));
    }

    /** The file's name. */
    public String name() {
        return "daylight_" + text(height) + "_" + text(direction) + "_" + text(haze) + "_" + text(clouds) + ".hdr";
    }

    private boolean isPossible() {
        return height >= 0
                && height <= Daylight.MAX_ELEVATION_DEGREES
                && haze >= Daylight.MIN_TURBIDITY
                && haze <= Daylight.MAX_TURBIDITY
                && clouds >= 0
                && clouds <= 1;
    }

    private static double number(Matcher name, int group) {
        return Double.parseDouble(name.group(group));
    }

    /** Without zeros at its end. */
    private static String text(double number) {
        String text = String.format(Locale.ROOT, "%.2f", number).replaceFirst("\\.?0+$", "");
        return text.equals("-0") || text.isEmpty() ? "0" : text;
    }

    private static Range degrees(double least, double most) {
        return new Range(least, most, "degrees");
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
