package dev.twister.gui.files;

import dev.twister.render.PictureFormat;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * How the window names files. To a chosen name that lacks the ending of its kind the ending is added. The file dialog
 * asked about replacing a file of the chosen name only, so a file of the name with the ending is never replaced: a
 * number is added.
 */
public final class FileNames {
    private static final String SCHEMA_ENDING = ".schema";
    public static final String PNG = PictureFormat.PNG.ending();
    public static final String HDR = PictureFormat.HDR.ending();
    public static final String EXR = PictureFormat.EXR.ending();
    public static final String SCENE = ".json";

    private FileNames() {}

    /** The last part of a path. */
    public static String name(Path file) {
        return Optional.ofNullable(file.getFileName()).map(Path::toString).orElse("the scene");
    }

    static Path absolute(Path file) {
        return file.toAbsolutePath().normalize();
    }

    /** The file name patterns of scenes in dialogs, which leave out the schema. */
    public static List<String> scenePatterns() {
        return scenePatterns(System.getProperty("os.name", ""));
    }

    /** Linux's dialogs take sets of letters; others take endings alone. */
    static List<String> scenePatterns(String system) {
        if (!system.toLowerCase(Locale.ROOT).startsWith("linux")) {
            return List.of("*" + SCENE);
        }
        List<String> patterns = new ArrayList<>();
        for (int same = 0; same < SCHEMA_ENDING.length(); same++) {
            String end = SCHEMA_ENDING.substring(SCHEMA_ENDING.length() - same) + SCENE;
            char other = SCHEMA_ENDING.charAt(SCHEMA_ENDING.length() - same - 1);
            patterns.add("*[!" + other + "]" + end);
            patterns.add(end);
        }
        return patterns;
    }

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

    /** A scene's file: {@value #SCENE} is added to a name with another ending, or without one. */
    public static Path forScene(Path chosen) {
        return withEnding(chosen, SCENE);
    }

    /**
     * A picture's file.
     *
     * @param ending of the kind that was chosen
     */
    public static Path forPicture(Path chosen, String ending) {
        return spared(chosen, ending.equals(PNG) ? withEnding(chosen) : asLinear(chosen, ending));
    }

    /** A file of the kind with that ending, which is added to a name with another one. */
    public static Path withEnding(Path chosen, String ending) {
        String name = chosen.getFileName().toString();
        return name.toLowerCase(Locale.ROOT).endsWith(ending)
                ? chosen
                : spared(chosen, chosen.resolveSibling(name + ending));
    }

    private static Path spared(Path chosen, Path ended) {
        String name = ended.getFileName().toString();
        int dot = name.lastIndexOf('.');
        Path free = ended;
        for (int number = 2; !free.equals(chosen) && Files.exists(free); number++) {
            free = ended.resolveSibling(name.substring(0, dot) + "-" + number + name.substring(dot));
        }
        return free;
    }
}
