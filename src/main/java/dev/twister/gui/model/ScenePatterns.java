package dev.twister.gui.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The file name patterns of scenes in dialogs, which leave out the schema. */
public final class ScenePatterns {
    private static final String SCHEMA = ".schema";

    private ScenePatterns() {}

    public static List<String> ofThisSystem() {
        return of(System.getProperty("os.name", ""));
    }

    /** Linux's dialogs take sets of letters; others take endings alone. */
    public static List<String> of(String system) {
        if (!system.toLowerCase(Locale.ROOT).startsWith("linux")) {
            return List.of("*" + ChosenFile.SCENE);
        }
        List<String> patterns = new ArrayList<>();
        for (int same = 0; same < SCHEMA.length(); same++) {
            String end = SCHEMA.substring(SCHEMA.length() - same) + ChosenFile.SCENE;
            char other = SCHEMA.charAt(SCHEMA.length() - same - 1);
            patterns.add("*[!" + other + "]" + end);
            patterns.add(end);
        }
        return patterns;
    }
}
