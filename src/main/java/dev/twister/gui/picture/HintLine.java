package dev.twister.gui.picture;

import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.HBox;

/** What a newcomer needs first, over the picture's lower edge, until the picture is used for the first time. */
public final class HintLine extends HBox {
    static final String TEXT = "W A S D: walk  ·  Drag: look around  ·  Click: select  ·  F1: all keys";

    private final Runnable whenDone;

    /**
     * A line that is seen at once.
     *
     * @param whenDone called once, when it goes away
     */
    public HintLine(PictureView picture, Runnable whenDone) {
        this.whenDone = whenDone;
        getStyleClass().add("hint-line");
        setId("hint-line");
        setAlignment(Pos.CENTER);
        setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
        Label text = new Label(TEXT);
        text.setMinWidth(0);
        Button close = new Button("✕");
        close.setId("close-hint");
        close.setAccessibleText("Close the hint");
        close.setFocusTraversable(false);
        close.setOnAction(_ -> leave());
        getChildren().addAll(text, close);
        managedProperty().bind(visibleProperty());
        picture.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (!event.getCode().isModifierKey()) {
                leave();
            }
        });
        picture.addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> leave());
        picture.addEventFilter(ScrollEvent.SCROLL, _ -> leave());
    }

    private void leave() {
        if (isVisible()) {
            setVisible(false);
            whenDone.run();
        }
    }
}
