package dev.twister.gui.files;

import dev.twister.render.PictureFormat;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** A screenshot's file, of a kind that its name tells. */
public final class PictureFile {
    public static final String PNG = PictureFormat.PNG.ending();
    public static final String HDR = PictureFormat.HDR.ending();
    public static final String EXR = PictureFormat.EXR.ending();

    private PictureFile() {}

    /** Whether a file of that name holds linear radiance; any other is a PNG. */
    public static boolean isLinear(Path file) {
        return PictureFormat.of(file).filter(PictureFormat::isLinear).isPresent();
    }

    /** Whether a file of that name holds it as OpenEXR. */
    public static boolean isExr(Path file) {
        return PictureFormat.of(file).equals(Optional.of(PictureFormat.EXR));
    }

    /** The file; with the ending of PNG added if its name has none of a picture. */
    public static Path withEnding(Path file) {
        return PictureFormat.of(file).isPresent() ? file : file.resolveSibling(file.getFileName() + PNG);
    }

    /** The file with the ending of a linear format, which replaces that of PNG; one with such an ending stays. */
    public static Path asLinear(Path file, String ending) {
        String name = file.getFileName().toString();
        boolean png = name.toLowerCase(Locale.ROOT).endsWith(PNG);
        String stem = png ? name.substring(0, name.length() - PNG.length()) : name;
        return isLinear(file) ? file : file.resolveSibling(stem + ending);
    }

    /** A name in a folder that is still free: {@code twister-1.png} and so on. */
    public static String freeName(Path folder) {
        int number = 1;
        while (isTaken(folder, number)) {
            number++;
        }
        return name(number, PNG);
    }

    private static boolean isTaken(Path folder, int number) {
        return Stream.of(PNG, HDR, EXR).anyMatch(ending -> Files.exists(folder.resolve(name(number, ending))));
    }

    private static String name(int number, String ending) {
        return "twister-" + number + ending;
    }
}
