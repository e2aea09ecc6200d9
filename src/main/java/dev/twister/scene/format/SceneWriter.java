package dev.twister.scene.format;

import dev.twister.files.SystemReason;
import dev.twister.files.WholeFile;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.Excerpt;
import dev.twister.scene.format.json.SourceFile;
import dev.twister.scene.format.json.SourceText;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/** Writes scene files that {@link SceneReader} reads back to an equal scene. */
public final class SceneWriter {
    private SceneWriter() {}

    /**
     * Writes a scene, whole or not at all: an existing file is replaced only once the new one is safely on the disk.
     * The same scene gives the same bytes, but for a {@code $schema} that an existing file has, which is kept. The
     * skybox and textures are written relative to the file's folder, where they can be; they need not be there. The
     * file is of the oldest version of the format that has all that the scene needs.
     *
     * @param file a file in an existing folder
     * @throws SceneException if a value of the scene is out of range, or the file cannot be written; the message is one
     *     line
     */
    public static void write(Scene scene, Path file) {
        write(scene, file, file);
    }

    /**
     * Writes a scene, as {@link #write(Scene, Path)}.
     *
     * @param like the file whose {@code $schema} is kept, where it has one; need not exist. In another folder it is
     *     kept if it is a URL or a file that is there
     */
    public static void write(Scene scene, Path file, Path like) {
        String name = file.toString();
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw failure(name, "is a folder or a device, but must be a file");
        }
        try {
            String text = SceneDocument.of(
                    scene,
                    new FilesBeside(file, WholeFile.behindLinks(file), false),
                    SchemaReference.of(like).filter(schema -> isKept(schema, file, like)));
            check(text, name + " (not written)");
            WholeFile.replace(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
        } catch (NoSuchFileException e) {
            throw failure(name, "there is no folder to write it in");
        } catch (IOException e) {
            throw failure(name, Excerpt.sentence(SystemReason.of(e)));
        }
    }

    /**
     * The text of a scene file in the current folder.
     *
     * @throws SceneException if a value of the scene is out of range; the message is one line
     */
    public static String text(Scene scene) {
        Path file = Path.of("scene.json").toAbsolutePath();
        String text = SceneDocument.of(scene, new FilesBeside(file, file, false), Optional.empty());
        check(text, "scene");
        return text;
    }

    /**
     * Checks that a scene could be written; its files need not be there.
     *
     * @throws SceneException if a value of the scene is out of range; the message is one line
     */
    public static void check(Scene scene) {
        check(SceneDocument.of(scene, NamedFiles.UNRESOLVED, Optional.empty()), "scene");
    }

    /** A copy elsewhere names no schema that is not there. */
    private static boolean isKept(String schema, Path file, Path like) {
        boolean elsewhere = !file.toAbsolutePath()
                .resolveSibling("")
                .equals(like.toAbsolutePath().resolveSibling(""));
        return !elsewhere
                || schema.contains("://")
                || Files.exists(file.toAbsolutePath().resolveSibling(schema));
    }

    // The reader has the rules; to ask it is surer than to have them twice.
    private static void check(String text, String name) {
        int bytes = text.getBytes(StandardCharsets.UTF_8).length;
        if (bytes > SourceFile.MAX_BYTES) {
            throw failure(
                    name, "the scene takes " + bytes + " bytes; a scene file may have at most " + SourceFile.MAX_BYTES);
        }
        SceneDocument.parse(SourceText.unwritten(name, text), NamedFiles.UNRESOLVED);
    }

    private static SceneException failure(String name, String what) {
        return SourceFile.failure(name, "cannot be written: " + what);
    }
}
