package dev.twister.gui;

import javafx.animation.PauseTransition;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.util.Duration;

/** One line under the picture: what is drawn, and what is going on. */
final class StatusLine extends HBox implements AutoCloseable {
    private static final Duration NOTICE_TIME = Duration.seconds(10);

    private final PauseTransition goodForAWhile = new PauseTransition(NOTICE_TIME);

    StatusLine(Studio studio) {
        getStyleClass().add("status");
        setAlignment(Pos.CENTER_LEFT);
        Label facts = new Label("starting…");
        facts.setId("facts");
        facts.setMinWidth(0);
        Label message = new Label();
        message.setId("message");
        message.setMinWidth(0);
        Label notice = new Label();
        notice.setId("notice");
        notice.setMinWidth(0);
        goodForAWhile.setOnFinished(_ -> studio.notice(""));
        Region gap = new Region();
        setHgrow(gap, Priority.ALWAYS);
        getChildren().addAll(facts, gap, notice, message);
        studio.pictureProperty()
                .subscribe(picture -> picture.map(StatusText::facts).ifPresent(facts::setText));
        studio.noticeProperty().subscribe(text -> {
            notice.setText(text);
            if (!text.isEmpty()) {
                goodForAWhile.playFromStart();
            }
        });
        studio.drawingProperty().subscribe(status -> message.setText(StatusText.message(status)));
    }

    /** Lets go of the notice's time, which would keep the window in memory. */
    @Override
    public void close() {
        goodForAWhile.stop();
    }
}
