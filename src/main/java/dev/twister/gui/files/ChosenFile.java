package dev.twister.gui.files;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The file to write if the chosen name lacks the ending of its kind. The file dialog asked about replacing a file of
 * the chosen name only, so a file of the name with the ending is never replaced: a number is added.
 */
public final class ChosenFile {
    public static final String SCENE = ".json";

    private ChosenFile() {}

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
        return spared(
                chosen,
                ending.equals(PictureFile.PNG) ? PictureFile.withEnding(chosen) : PictureFile.asLinear(chosen, ending));
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
