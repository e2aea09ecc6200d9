package dev.twister.gui.gallery;

import dev.twister.gui.controls.OwnedWindows;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.FileActions;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.WindowSettings;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
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
        Stage stage = window.orElseGet(this::create);
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

    private Stage create() {
        Stage stage = new Stage();
        stage.initOwner(owner);
        OwnedWindows.center(stage, owner);
        stage.setTitle("Scenes");
        Scene scene = new Scene(new StackPane(), WIDTH, HEIGHT);
        scene.getStylesheets().setAll(owner.getScene().getStylesheets());
        scene.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                stage.hide();
            }
        });
        stage.setScene(scene);
        return stage;
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
}
