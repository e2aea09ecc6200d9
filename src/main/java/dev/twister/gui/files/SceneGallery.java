package dev.twister.gui.files;

import dev.twister.engine.Engine;
import dev.twister.engine.JvmEngines;
import dev.twister.files.UserFolder;
import dev.twister.gui.controls.OwnedWindows;
import dev.twister.gui.controls.Tooltips;
import dev.twister.image.Frame;
import dev.twister.image.PngWriter;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.TilePane;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;

/** A window with the recent and the shipped scenes as pictures; a click opens one. */
public final class SceneGallery implements AutoCloseable {
    private static final double WIDTH = 1030;
    private static final double HEIGHT = 680;

    private final Stage owner;
    private final SettingsKeeper settings;
    private final FileActions files;
    private final Thumbnails thumbnails = Thumbnails.ofThisUser();
    private Optional<Stage> window = Optional.empty();

    public SceneGallery(Stage owner, SettingsKeeper settings, FileActions files) {
        this.owner = owner;
        this.settings = settings;
        this.files = files;
    }

    /** Shows the window with what is there now. */
    public void show() {
        Stage stage = window.orElseGet(() -> OwnedWindows.createHiddenByEscape(
                owner, "Scenes", new javafx.scene.Scene(new StackPane(), WIDTH, HEIGHT)));
        window = Optional.of(stage);
        TilePane start = tiles();
        start.getChildren()
                .addAll(
                        tile("New scene", "A floor, a sky and a light", "+", files::newScene),
                        tile("Open…", "A scene, a mesh or a panorama", "…", files::open));
        VBox page = new VBox(start);
        page.setId("gallery-page");
        page.getStyleClass().add("page");
        addSection(
                page,
                "Recent",
                settings.settings().get(WindowSettings.RECENT_SCENES).stream()
                        .map(Path::of)
                        .toList());
        ScrollPane scroll = new ScrollPane(page);
        scroll.setFitToWidth(true);
        scroll.getStyleClass().add("help");
        stage.getScene().setRoot(scroll);
        files.listShipped(scenes -> addSection(page, "Shipped", scenes));
        stage.show();
        stage.toFront();
        start.getChildren().getFirst().requestFocus();
    }

    private void addSection(VBox page, String heading, List<Path> scenes) {
        if (!scenes.isEmpty()) {
            Label label = new Label(heading);
            label.getStyleClass().add("heading");
            TilePane tiles = tiles();
            scenes.forEach(scene -> tiles.getChildren().add(tile(scene)));
            page.getChildren().addAll(label, tiles);
        }
    }

    private static TilePane tiles() {
        TilePane tiles = new TilePane();
        tiles.getStyleClass().add("gallery");
        return tiles;
    }

    private Button tile(Path scene) {
        String name = scene.getFileName().toString().replaceFirst("\\.json$", "");
        ImageView picture = new ImageView();
        StackPane frame = frame(picture);
        Button tile = tile(name, scene.toString(), frame, () -> files.open(scene));
        thumbnails.want(scene, picture::setImage);
        return tile;
    }

    private Button tile(String name, String hint, String sign, Runnable action) {
        Label label = new Label(sign);
        label.getStyleClass().add("gallery-sign");
        return tile(name, hint, frame(label), action);
    }

    private static StackPane frame(Node inner) {
        StackPane frame = new StackPane(inner);
        frame.getStyleClass().add("gallery-frame");
        frame.setMinSize(Thumbnails.WIDTH, Thumbnails.HEIGHT);
        frame.setPrefSize(Thumbnails.WIDTH, Thumbnails.HEIGHT);
        return frame;
    }

    private Button tile(String name, String hint, Node picture, Runnable action) {
        Button tile = new Button(name, picture);
        tile.getStyleClass().add("gallery-tile");
        tile.setContentDisplay(ContentDisplay.TOP);
        tile.setMnemonicParsing(false);
        tile.setTooltip(Tooltips.of(hint));
        tile.setOnAction(_ -> {
            window.ifPresent(Stage::hide);
            action.run();
        });
        tile.setOnKeyPressed(event -> {
            if (event.getCode() == KeyCode.ENTER) {
                tile.fire();
                event.consume();
            }
        });
        return tile;
    }

    @Override
    public void close() {
        window.ifPresent(Stage::hide);
        thumbnails.close();
    }

    /**
     * Small pictures of scene files, rendered one after the other on a thread of their own and kept in the user's cache
     * until the scene's file changes.
     */
    static final class Thumbnails implements AutoCloseable {
        static final int WIDTH = 224;
        static final int HEIGHT = 126;

        private static final int TRACED_SAMPLES = 32;
        private static final int SAMPLES = 16;
        private static final int SHADOW_SAMPLES = 4;

        private final Optional<Path> folder;
        private final ExecutorService thread = Executors.newSingleThreadExecutor(
                Thread.ofPlatform().daemon().name("thumbnails").factory());
        private volatile boolean closed;

        /** @param folder need not exist; without one nothing is kept */
        Thumbnails(Optional<Path> folder) {
            this.folder = folder;
        }

        static Thumbnails ofThisUser() {
            return new Thumbnails(UserFolder.CACHE.ofThisUser().map(own -> own.resolve("thumbnails")));
        }

        /** @param done gets the picture on JavaFX's thread; not called if the scene cannot be read */
        void want(Path scene, Consumer<Image> done) {
            if (!closed) {
                thread.execute(() -> find(scene).ifPresent(image -> Platform.runLater(() -> done.accept(image))));
            }
        }

        private Optional<Image> find(Path scene) {
            if (closed) {
                return Optional.empty();
            }
            try {
                Path kept = folder.orElseGet(() -> Path.of(System.getProperty("java.io.tmpdir")))
                        .resolve(name(scene));
                if (!Files.exists(kept)) {
                    Files.createDirectories(kept.resolveSibling(""));
                    render(scene, kept);
                }
                return Optional.of(new Image(kept.toUri().toString()));
            } catch (IOException | RuntimeException | OutOfMemoryError _) {
                // The tile stays without a picture; opening the scene tells why.
                return Optional.empty();
            }
        }

        /** Another name where the file has changed. */
        private static String name(Path scene) throws IOException {
            String version =
                    scene.toAbsolutePath() + "\n" + Files.getLastModifiedTime(scene) + "\n" + Files.size(scene);
            return UUID.nameUUIDFromBytes(version.getBytes(StandardCharsets.UTF_8)) + ".png";
        }

        private static void render(Path file, Path picture) throws IOException {
            Scene scene = VisibleBodies.of(SceneReader.read(file));
            boolean noisy = scene.rendering().integrator().isNoisy();
            Scene small = scene.withRendering(scene.rendering()
                    .withSize(WIDTH, HEIGHT)
                    .withSamplesPerPixel(noisy ? TRACED_SAMPLES : SAMPLES)
                    .withShadowSamples(Math.min(scene.rendering().shadowSamples(), SHADOW_SAMPLES)));
            SceneMeshes meshes = SceneMeshes.read(small, _ -> {});
            FrameInput input = World.of(small, SceneImages.read(small, meshes, _ -> {}), meshes)
                    .snapshot();
            Frame frame = Frame.ofPixels(WIDTH, HEIGHT);
            try (Engine engine = JvmEngines.parallel().opener().get()) {
                engine.render(input, frame);
            }
            PngWriter.write(picture, WIDTH, HEIGHT, frame.argb(), input.srgb());
        }

        /** Renders no more; returns at once. */
        @Override
        public void close() {
            closed = true;
            thread.shutdownNow();
        }
    }
}
