package dev.twister.gui.model;

import dev.twister.scene.select.Title;
import java.nio.file.Path;

/** The title of a scene that is saved under another name: its own, unless someone has changed it. */
public final class CopiedTitle {
    private CopiedTitle() {}

    /**
     * The title of the copy.
     *
     * @param title that the scene has now
     * @param original that of the file it was read from
     * @param shipped whether that is a shipped scene, whose description is of no other
     */
    public static Title of(Title title, Title original, Path copy, boolean shipped) {
        Title named = title.name().equals(original.name()) ? title.withName(stem(copy)) : title;
        boolean described = !shipped || !title.description().equals(original.description());
        return described ? named : named.withDescription("");
    }

    private static String stem(Path file) {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
