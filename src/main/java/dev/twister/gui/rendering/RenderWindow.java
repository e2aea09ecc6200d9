package dev.twister.gui.rendering;

import dev.twister.gui.controls.OwnedWindows;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;

/** The render window: a form, the progress, and buttons. */
final class RenderWindow {
    private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");

    private final Stage stage;
    private final RenderForm form;
    private final Button render = button("render-start", "_Render…");
    private final Button cancel = button("render-cancel", "_Cancel render");
    private final ProgressBar bar = new ProgressBar(0);
    private final Label state = new Label();
    private final WaitingRenders waiting = new WaitingRenders();
    private boolean rendering;

    /** The result of the last render, shown while the form is valid. */
    private String said = "";

    /**
     * A window that is not shown yet.
     *
     * @param start starts the render of the form
     * @param stop cancels it
     */
    RenderWindow(Stage owner, RenderForm form, Runnable start, Runnable stop) {
        this.form = form;
        Button close = button("render-close", "Close");
        render.setDefaultButton(true);
        render.setOnAction(_ -> start.run());
        cancel.setOnAction(_ -> {
            // The focused button is about to disappear.
            close.requestFocus();
            stop.run();
        });
        close.setCancelButton(true);
        bar.setId("render-bar");
        bar.setMaxWidth(Double.MAX_VALUE);
        state.setId("render-state");
        state.setWrapText(true);
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox buttons = new HBox(gap, cancel, render, close);
        buttons.getStyleClass().add("buttons");
        VBox page = new VBox(form, new VBox(bar, state, waiting), buttons);
        page.setId("render-page");
        page.getStyleClass().add("page");
        stage = OwnedWindows.create(owner, "Render to file", new Scene(page));
        stage.setResizable(false);
        close.setOnAction(_ -> stage.hide());
        form.complaintProperty().subscribe(_ -> refresh());
        form.heightProperty().subscribe(_ -> stage.sizeToScene());
        waiting.heightProperty().subscribe(_ -> stage.sizeToScene());
    }

    /** Shows the window, or brings it to the front. */
    void show() {
        form.follow();
        stage.show();
        stage.toFront();
    }

    boolean isShowing() {
        return stage.isShowing();
    }

    void close() {
        stage.hide();
    }

    /**
     * Shows the progress.
     *
     * @param part that is done, in [0, 1]; empty if unknown
     */
    void showProgress(String text, Optional<Double> part) {
        rendering = true;
        said = text;
        bar.setProgress(part.orElse(ProgressBar.INDETERMINATE_PROGRESS));
        refresh();
    }

    /** Shows the result of the last render. */
    void showEnd(String text) {
        rendering = false;
        said = text;
        bar.setProgress(0);
        refresh();
    }

    /**
     * Shows what waits for the present render.
     *
     * @param remove gets the place in the queue of one to remove
     */
    void showWaiting(List<String> names, IntConsumer remove) {
        waiting.show(names, remove);
    }

    private void refresh() {
        Optional<String> complaint = form.complaintProperty().get();
        render.setText(rendering ? "Add to _queue…" : "_Render…");
        bar.setVisible(rendering);
        cancel.setVisible(rendering);
        render.setDisable(complaint.isPresent());
        state.pseudoClassStateChanged(WRONG, complaint.isPresent());
        state.setText(complaint.orElse(said));
    }

    private static Button button(String id, String label) {
        Button button = new Button(label);
        button.setId(id);
        return button;
    }

    /** The renderings that wait for the present one, each with a button to remove it. */
    private static final class WaitingRenders extends VBox {
        private List<String> shown = List.of();

        WaitingRenders() {
            setId("render-waiting");
            managedProperty().bind(visibleProperty());
            setVisible(false);
        }

        /** @param remove gets the place in the queue */
        void show(List<String> names, IntConsumer remove) {
            if (!names.equals(shown)) {
                shown = List.copyOf(names);
                getChildren().clear();
                for (int place = 0; place < shown.size(); place++) {
                    getChildren().add(row(shown.get(place), place, remove));
                }
                setVisible(!shown.isEmpty());
            }
        }

        private static HBox row(String name, int place, IntConsumer remove) {
            Label label = new Label("Waiting: " + name);
            label.setMaxWidth(Double.MAX_VALUE);
            HBox.setHgrow(label, Priority.ALWAYS);
            Button button = new Button("Remove");
            button.setAccessibleText("Remove " + name + " from the queue");
            button.setOnAction(_ -> remove.accept(place));
            HBox row = new HBox(label, button);
            row.setAlignment(Pos.CENTER_LEFT);
            row.getStyleClass().add("render-fields");
            return row;
        }
    }
}
