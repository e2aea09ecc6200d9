package dev.twister.gui.files;

import dev.twister.files.InputFile;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.Scene;
import javafx.scene.input.TransferMode;

/** Tells what a file is that someone opens or drops on the window, by its first bytes and its name. */
public final class DroppedFile {
    private static final String SCHEMA = ".schema.json";
    private static final int LOOKED_AT = 256;
    private static final String EXPECTED =
            "a scene (.json), a mesh (.obj, .gltf, .glb, .ply, .stl) or a panorama (.hdr, .exr, .png, .jpg)";

    /** What to read it as; whether it is one is for that reader to say. */
    public enum Kind {
        SCENE,
        SKYBOX,
        MESH,
        /** A folder, a device, or what neither ends nor starts like one of them. */
        OTHER
    }

    private DroppedFile() {}

    /** Lets a window take files that are dropped on it. */
    public static void accept(Scene scene, Consumer<List<Path>> dropped) {
        scene.setOnDragOver(event -> {
            if (event.getDragboard().hasFiles()) {
                event.acceptTransferModes(TransferMode.COPY);
            }
            event.consume();
        });
        scene.setOnDragDropped(event -> {
            boolean hasFiles = event.getDragboard().hasFiles();
            if (hasFiles) {
                dropped.accept(event.getDragboard().getFiles().stream()
                        .map(File::toPath)
                        .toList());
            }
            event.setDropCompleted(hasFiles);
            event.consume();
        });
    }

    /** Reads at most the first {@value #LOOKED_AT} bytes. A file that is gone is what its name says. */
    public static Kind kind(Path file) {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            return Kind.OTHER;
        }
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        if (name.endsWith(SCHEMA)) {
            return Kind.OTHER;
        }
        return kindByContent(file).orElseGet(() -> kindByName(name));
    }

    private static Kind kindByName(String name) {
        if (name.endsWith(".json")) {
            return Kind.SCENE;
        }
        if (name.matches(".*\\.(hdr|exr|pic|png|jpe?g|webp)")) {
            return Kind.SKYBOX;
        }
        return name.matches(".*\\.(obj|gltf|glb|ply|stl)") ? Kind.MESH : Kind.OTHER;
    }

    /** What to say of a file that is none of them. */
    public static String complaint(Path file) {
        Optional<String> problem = InputFile.problem(file);
        if (problem.isPresent()) {
            return file + ": " + problem.get();
        }
        if (file.toString().toLowerCase(Locale.ROOT).endsWith(SCHEMA)) {
            return file + ": describes scenes for editors, and is none itself";
        }
        return file + ": unknown kind of file; expected " + EXPECTED;
    }

    /** Empty where the name has to tell. */
    private static Optional<Kind> kindByContent(Path file) {
        byte[] start;
        try (InputStream in = Files.newInputStream(file)) {
            start = in.readNBytes(LOOKED_AT);
        } catch (IOException _) {
            return Optional.empty();
        }
        String text = new String(start, StandardCharsets.ISO_8859_1);
        if (text.stripLeading().startsWith("{")) {
            boolean mesh = file.toString().toLowerCase(Locale.ROOT).endsWith(".gltf");
            return Optional.of(mesh ? Kind.MESH : Kind.SCENE);
        }
        boolean panorama = text.startsWith("#?")
                || text.startsWith("\u0089PNG")
                || text.startsWith("\u00ff\u00d8")
                || text.startsWith("v/1\u0001");
        if (panorama) {
            return Optional.of(Kind.SKYBOX);
        }
        boolean mesh = text.startsWith("ply\n") || text.startsWith("ply\r") || text.startsWith("glTF");
        return mesh ? Optional.of(Kind.MESH) : Optional.empty();
    }
}
