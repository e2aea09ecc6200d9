package dev.twister.gui;

import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.files.Reading;
import dev.twister.gui.files.ReadingView;
import dev.twister.gui.studio.StatusText;
import dev.twister.gui.studio.Studio;
import java.util.concurrent.TimeUnit;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;

/** One line under the picture: what is drawn, and what is going on. */
final class StatusLine extends HBox {
    private static final long NOTICE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long LEAST_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final Studio studio;
    private final ReadingView readingView;
    private long noticedNanos;

    StatusLine(Studio studio, Reading reading) {
        this.studio = studio;
        getStyleClass().add("status");
        setAlignment(Pos.CENTER_LEFT);
        Label facts = label("facts");
        facts.setText("starting…");
        Label message = aside("message");
        Label notice = aside("notice");
        Region gap = new Region();
        setHgrow(gap, Priority.ALWAYS);
        readingView = new ReadingView(studio, reading);
        getChildren().addAll(facts, gap, notice, message, readingView);
        studio.pictureProperty()
                .subscribe((before, picture) -> picture.filter(now -> before.filter(old -> StatusText.isSame(old, now))
                                .isEmpty())
                        .ifPresent(now -> facts.setText(StatusText.facts(now))));
        studio.noticeProperty().subscribe(text -> {
            notice.setText(text);
            noticedNanos = System.nanoTime();
        });
        studio.drawingProperty().subscribe(status -> message.setText(StatusText.message(status)));
    }

    /** Adds what goes on in the background. */
    void add(Node activity) {
        getChildren().add(activity);
    }

    /** Clears an old notice when a key or a button is pressed. */
    void clearAtNextAction(Scene scene) {
        scene.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (!event.getCode().isModifierKey()) {
                clearOld();
            }
        });
        scene.addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> clearOld());
    }

    /** A notice that has just come was not read yet. */
    private void clearOld() {
        clearAfter(LEAST_NANOS, System.nanoTime());
    }

    private void clearAfter(long age, long nanos) {
        if (nanos - noticedNanos > age && !studio.noticeProperty().get().isEmpty()) {
            studio.notice("");
        }
    }

    /** Called in every pulse, and a few times a second at rest: a timer of JavaFX would ask for pulses itself. */
    void pulse(long nanos) {
        clearAfter(NOTICE_NANOS, nanos);
        readingView.pulse(nanos);
    }

    /** A label that takes room only while it says something. */
    private static Label aside(String id) {
        Label label = label(id);
        label.managedProperty().bind(label.textProperty().isNotEmpty());
        return label;
    }

    /** A label that may be cut off; its tooltip has the whole text. */
    private static Label label(String id) {
        Label label = new Label();
        label.setId(id);
        label.setMinWidth(0);
        label.setTooltip(new Tooltip());
        label.textProperty().subscribe(text -> label.getTooltip().setText(Tooltips.wrap(text)));
        return label;
    }
}
