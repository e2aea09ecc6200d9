package dev.twister.gui.model;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * What is written where a person chose a name without the ending that the file's kind has. They were asked whether to
 * replace a file of the name they chose: one of the name with the ending is never replaced, but a number added.
 */
public final class ChosenFile {
    public static final String SCENE = ".json";

    private ChosenFile() {}

    /** A scene's file: {@value #SCENE} is added where there is no ending at all. */
    public static Path forScene(Path chosen) {
        String name = chosen.getFileName().toString();
        return name.contains(".") ? chosen : spared(chosen, chosen.resolveSibling(name + SCENE));
    }

    /** A picture's file, of either kind. */
    public static Path forPicture(Path chosen, boolean linear) {
        return spared(chosen, linear ? PictureFile.asHdr(chosen) : PictureFile.withEnding(chosen));
    }

    /** A file of a kind that has that ending: it is added where the name has another one. */
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
