package dev.twister.gui.model;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Tells what a file is that someone opens or drops on the window, by its name and its first bytes. */
public final class DroppedFile {
    private static final String SCHEMA = ".schema.json";
    private static final int LOOKED_AT = 256;

    /** What to read it as; whether it is one is for that reader to say. */
    public enum Kind {
        SCENE,
        SKYBOX,
        /** A folder, a device, or what neither ends nor starts like one of them. */
        NEITHER
    }

    private DroppedFile() {}

    /** Reads at most the first {@value #LOOKED_AT} bytes. A file that is gone is what its name says. */
    public static Kind kind(Path file) {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            return Kind.NEITHER;
        }
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        if (name.endsWith(SCHEMA)) {
            return Kind.NEITHER;
        }
        if (name.endsWith(".json")) {
            return Kind.SCENE;
        }
        if (name.matches(".*\\.(hdr|pic|png|jpe?g)")) {
            return Kind.SKYBOX;
        }
        return kindByContent(file);
    }

    /** What to say of a file that is neither. */
    public static String complaint(Path file) {
        if (Files.isDirectory(file)) {
            return file + ": is a folder, but must be a scene (.json) or a panorama (.hdr, .png, .jpg)";
        }
        if (Files.exists(file) && file.toString().toLowerCase(Locale.ROOT).endsWith(SCHEMA)) {
            return file + ": describes scenes for editors, and is none itself";
        }
        return file
                + (Files.exists(file)
                        ? ": neither a scene (.json) nor a panorama (.hdr, .png, .jpg)"
                        : ": file not found");
    }

    private static Kind kindByContent(Path file) {
        byte[] start;
        try (InputStream in = Files.newInputStream(file)) {
            start = in.readNBytes(LOOKED_AT);
        } catch (IOException _) {
            return Kind.NEITHER;
        }
        String text = new String(start, StandardCharsets.ISO_8859_1);
        if (text.stripLeading().startsWith("{")) {
            return Kind.SCENE;
        }
        boolean panorama = text.startsWith("#?") || text.startsWith("\u0089PNG") || text.startsWith("\u00ff\u00d8");
        return panorama ? Kind.SKYBOX : Kind.NEITHER;
    }
}
