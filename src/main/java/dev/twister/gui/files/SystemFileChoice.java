package dev.twister.gui.files;

import dev.twister.gui.model.ChosenFile;
import dev.twister.gui.model.PictureFile;
import dev.twister.gui.model.ScenePatterns;
import dev.twister.mesh.MeshReader;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.stage.DirectoryChooser;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/** Asks with the system's dialogs. */
public final class SystemFileChoice implements FileChoice {
    private static final String SCENE = "*" + ChosenFile.SCENE;
    private static final List<String> PANORAMAS =
            List.of("*.hdr", "*.exr", "*.pic", "*.png", "*.jpg", "*.jpeg", "*.webp");
    private static final List<String> PICTURES = List.of("*.exr", "*.hdr", "*.png");
    private static final List<String> MESHES =
            MeshReader.ENDINGS.stream().map(ending -> "*" + ending).toList();
    private static final List<String> TEXTURES = List.of("*.png", "*.jpg", "*.jpeg", "*.webp");

    private final Window owner;

    public SystemFileChoice(Window owner) {
        this.owner = owner;
    }

    @Override
    public Optional<Path> toOpen(Path folder) {
        FileChooser chooser = chooser("Open a scene, a mesh or a panorama", folder);
        chooser.getExtensionFilters()
                .addAll(
                        new ExtensionFilter("Scenes, meshes and panoramas", all()),
                        new ExtensionFilter("Scenes", ScenePatterns.ofThisSystem()),
                        new ExtensionFilter("Meshes", MESHES),
                        new ExtensionFilter("Panoramas", PANORAMAS),
                        new ExtensionFilter("All files", "*"));
        return path(chooser.showOpenDialog(owner));
    }

    @Override
    public Optional<Path> toSaveScene(Path suggested) {
        FileChooser chooser = chooser("Save the scene", parent(suggested));
        chooser.setInitialFileName(String.valueOf(suggested.getFileName()));
        chooser.getExtensionFilters().add(new ExtensionFilter("Scenes", SCENE));
        return path(chooser.showSaveDialog(owner)).map(ChosenFile::forScene);
    }

    @Override
    public Optional<Path> panorama(Path folder) {
        return toRead("Choose a sky", folder, new ExtensionFilter("Panoramas", PANORAMAS));
    }

    @Override
    public Optional<Path> picture(Path folder) {
        return toRead("View a picture", folder, new ExtensionFilter("Pictures", PICTURES));
    }

    @Override
    public Optional<Path> mesh(Path folder) {
        return toRead("Insert a mesh", folder, new ExtensionFilter("Meshes", MESHES));
    }

    @Override
    public Optional<Path> texture(Path folder) {
        return toRead("Choose a texture", folder, new ExtensionFilter("Textures", TEXTURES));
    }

    @Override
    public Optional<Path> toSavePicture(Path suggested) {
        FileChooser chooser = chooser("Save the picture", parent(suggested));
        chooser.setInitialFileName(String.valueOf(suggested.getFileName()));
        chooser.getExtensionFilters()
                .addAll(
                        new ExtensionFilter("As shown: PNG", "*" + PictureFile.PNG),
                        new ExtensionFilter("Linear radiance: HDR", "*" + PictureFile.HDR),
                        new ExtensionFilter("Linear radiance: EXR", "*" + PictureFile.EXR));
        Optional<Path> chosen = path(chooser.showSaveDialog(owner));
        String ending = Optional.ofNullable(chooser.getSelectedExtensionFilter())
                .map(filter -> filter.getExtensions().getFirst().substring(1))
                .orElse(PictureFile.PNG);
        return chosen.map(file -> ChosenFile.forPicture(file, ending));
    }

    @Override
    public Optional<Path> toRender(Path suggested, String kind, String ending) {
        FileChooser chooser = chooser("Render to file", parent(suggested));
        chooser.setInitialFileName(String.valueOf(suggested.getFileName()));
        chooser.getExtensionFilters().add(new ExtensionFilter(kind, "*" + ending));
        return path(chooser.showSaveDialog(owner)).map(file -> ChosenFile.withEnding(file, ending));
    }

    @Override
    public Optional<Path> folder(Path suggested) {
        DirectoryChooser chooser = new DirectoryChooser();
        chooser.setTitle("Record into a folder");
        existing(suggested).ifPresent(chooser::setInitialDirectory);
        return path(chooser.showDialog(owner));
    }

    private Optional<Path> toRead(String title, Path folder, ExtensionFilter kind) {
        FileChooser chooser = chooser(title, folder);
        chooser.getExtensionFilters().addAll(kind, new ExtensionFilter("All files", "*"));
        return path(chooser.showOpenDialog(owner));
    }

    private static List<String> all() {
        return Stream.of(ScenePatterns.ofThisSystem(), MESHES, PANORAMAS)
                .flatMap(List::stream)
                .toList();
    }

    private static FileChooser chooser(String title, Path folder) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(title);
        existing(folder).ifPresent(chooser::setInitialDirectory);
        return chooser;
    }

    private static Path parent(Path file) {
        return Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(Path.of(""));
    }

    private static Optional<File> existing(Path folder) {
        return Optional.of(folder).filter(Files::isDirectory).map(Path::toFile);
    }

    private static Optional<Path> path(File chosen) {
        return Optional.ofNullable(chosen).map(File::toPath);
    }
}
