package dev.twister.gui.model;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** A screenshot's file, of a kind that its name tells. */
public final class PictureFile {
    public static final String PNG = ".png";
    public static final String HDR = ".hdr";

    private PictureFile() {}

    /** Whether a file of that name holds linear radiance; any other is a PNG. */
    public static boolean isLinear(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(HDR);
    }

    /** The file; if its name ends in neither {@value #PNG} nor {@value #HDR}, with {@value #PNG} added. */
    public static Path withEnding(Path file) {
        String name = file.getFileName().toString();
        boolean known = isLinear(file) || name.toLowerCase(Locale.ROOT).endsWith(PNG);
        return known ? file : file.resolveSibling(name + PNG);
    }

    /** The file with the ending {@value #HDR}, which replaces {@value #PNG}. */
    public static Path asHdr(Path file) {
        String name = file.getFileName().toString();
        boolean png = name.toLowerCase(Locale.ROOT).endsWith(PNG);
        String stem = png ? name.substring(0, name.length() - PNG.length()) : name;
        return isLinear(file) ? file : file.resolveSibling(stem + HDR);
    }

    /** A name in a folder that is still free: {@code twister-1.png} and so on. */
    public static String freeName(Path folder) {
        int number = 1;
        while (Files.exists(folder.resolve(name(number, PNG))) || Files.exists(folder.resolve(name(number, HDR)))) {
            number++;
        }
        return name(number, PNG);
    }

    private static String name(int number, String ending) {
        return "twister-" + number + ending;
    }
}
