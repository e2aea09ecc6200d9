package dev.twister.gui.rendering;

import dev.twister.engine.EngineException;
import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.files.FileChoice;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Studio;
import dev.twister.render.RenderOrder;
import dev.twister.render.RenderOutput;
import dev.twister.render.SceneInputs;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.stage.Stage;

/** Renders to files in the background, one after the other; further ones wait. */
public final class RenderActions implements AutoCloseable {
    private static final String FAILED = "Couldn't render to the file";

    /** Longest wait for a canceled render: a slow engine finishes its picture first. */
    private static final Duration LONGEST_END = Duration.ofSeconds(5);

    private final Studio studio;
    private final FileChoice choice;
    private final Dialogs dialogs;
    private final RenderForm form;
    private final RenderWindow window;
    private final Status status = new Status(this::cancel);
    private final Deque<RenderOrder> waiting = new ArrayDeque<>();
    private Optional<RenderJob> job = Optional.empty();
    private Path lastFolder = Path.of("").toAbsolutePath();
    private boolean choosing;

    public RenderActions(Stage owner, Studio studio, EngineList engines, FileChoice choice, Dialogs dialogs) {
        this.studio = studio;
        this.choice = choice;
        this.dialogs = dialogs;
        form = new RenderForm(studio, engines);
        window = new RenderWindow(owner, form, this::start, this::cancel);
        studio.sceneProperty().subscribe(_ -> {
            if (window.isShowing()) {
                form.follow();
            }
        });
    }

    /** Shows the render window. */
    public void show() {
        window.show();
    }

    /** The progress while the window is closed, for the status line. */
    public Status status() {
        return status;
    }

    /** Called in every pulse: shows the progress or the result. */
    public void pulse() {
        job.filter(running -> running.result().isDone()).ifPresent(this::tellEnd);
        if (window.isShowing()) {
            form.showEstimate();
            job.ifPresent(running ->
                    window.showProgress(progress(running), running.progress().part()));
        }
        job.filter(_ -> !window.isShowing())
                .ifPresentOrElse(
                        running -> status.show(
                                FileNames.name(running.order().output().file()) + ": " + progress(running)
                                        + (waiting.isEmpty() ? "" : " · " + waiting.size() + " waiting"),
                                running.progress().part()),
                        status::hide);
    }

    private static String progress(RenderJob running) {
        return running.isCanceled() ? "Canceling…" : running.progress().text();
    }

    /** Runs an action that closes the window; if a render is running, asks first whether to cancel it. */
    public void beforeClosing(Runnable then) {
        if (job.isPresent()) {
            dialogs.askToCancelRender(
                    FileNames.name(job.get().order().output().file()), new Answer("Cancel render", () -> {
                        waiting.clear();
                        cancel();
                        then.run();
                    }));
        } else {
            then.run();
        }
    }

    /** Cancels all renders. Returns at once. */
    public void finish() {
        waiting.clear();
        cancel();
        window.close();
    }

    /** Waits for a canceled render to end; called after {@link #finish}, by any thread. */
    @Override
    public void close() {
        job.ifPresent(running -> {
            try {
                running.awaitEnd(LONGEST_END);
            } catch (InterruptedException _) {
                Thread.currentThread().interrupt();
            }
        });
    }

    private void cancel() {
        job.ifPresent(RenderJob::cancel);
    }

    private void start() {
        if (choosing) {
            return;
        }
        choosing = true;
        Path suggested = lastFolder.resolve(form.format().fileName(stem()));
        Optional<Path> chosen =
                choice.toRender(suggested, form.format().label(), form.format().ending());
        choosing = false;
        chosen.flatMap(form::order).ifPresent(this::startWhereFree);
    }

    private String stem() {
        String name = FileNames.name(studio.document().file());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    /** Asks before numbered frames are replaced; for single files the file dialog has asked. */
    private void startWhereFree(RenderOrder order) {
        Path file = order.output().file();
        lastFolder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(lastFolder);
        try {
            if (SceneInputs.areReplacedBy(file, SceneInputs.of(studio.document().file(), order.scene()))) {
                dialogs.complain(FAILED, file + " is a file of the scene; choose another one");
            } else {
                Optional<Path> there = firstFrameThere(order);
                if (there.isPresent()) {
                    dialogs.askToReplaceFrames(
                            FileNames.name(there.get()),
                            new Answer("Other name…", this::start),
                            new Answer("Replace", () -> start(order)));
                } else {
                    start(order);
                }
            }
        } catch (IOException problem) {
            dialogs.complain(FAILED, problem.getMessage());
        } catch (IllegalArgumentException problem) {
            dialogs.complain(FAILED, file + " " + problem.getMessage());
        }
    }

    private Optional<Path> firstFrameThere(RenderOrder order) {
        RenderOutput output = order.output();
        return output.range()
                .numbers()
                .mapToObj(output::file)
                .filter(_ -> output.isNumbered())
                .filter(Files::exists)
                .findFirst();
    }

    /** Starts a render, or puts it in the queue behind the present one. */
    private void start(RenderOrder order) {
        if (job.isPresent()) {
            waiting.add(order);
            showWaiting();
            studio.notice("Waiting for the present render: "
                    + FileNames.name(order.output().file()));
        } else {
            begin(order);
        }
    }

    private void showWaiting() {
        window.showWaiting(
                waiting.stream()
                        .map(order -> FileNames.name(order.output().file()))
                        .toList(),
                place -> {
                    List<RenderOrder> rest = new ArrayList<>(waiting);
                    rest.remove(place);
                    waiting.clear();
                    waiting.addAll(rest);
                    showWaiting();
                });
    }

    private void begin(RenderOrder order) {
        SceneMeshes meshes =
                studio.pictureProperty().get().map(DrawnPicture::meshes).orElse(SceneMeshes.NONE);
        job = Optional.of(RenderJob.start(order, () -> studio.assets().world(order.scene(), meshes), System::nanoTime));
        pulse();
    }

    private void tellEnd(RenderJob ended) {
        job = Optional.empty();
        switch (ended.result().state()) {
            case SUCCESS -> tell("Rendered " + ended.result().resultNow() + more(ended.order()));
            case CANCELLED -> tell("Render canceled");
            default -> {
                window.showEnd("");
                dialogs.complain(FAILED, explain(ended.result().exceptionNow()));
            }
        }
        Optional.ofNullable(waiting.poll()).ifPresent(next -> {
            showWaiting();
            begin(next);
        });
    }

    private static String more(RenderOrder order) {
        int frames = order.output().range().count();
        return frames == 1 ? "" : ", " + frames + " frames";
    }

    private static String explain(Throwable problem) {
        return problem instanceof EngineException ? problem.getMessage() : Dialogs.explain(problem);
    }

    private void tell(String what) {
        window.showEnd(what);
        studio.notice(what);
    }

    /** The progress of a rendering in the status line, with a button to cancel, while the render window is closed. */
    public static final class Status extends HBox {
        private final ProgressBar bar = new ProgressBar(0);
        private final Label text = new Label();

        /** @param stop cancels the rendering */
        Status(Runnable stop) {
            bar.setAccessibleText("Progress of the rendering");
            text.setId("rendering");
            text.setMinWidth(0);
            Button cancel = new Button("Cancel");
            cancel.setId("cancel-rendering");
            cancel.setTooltip(Tooltips.of("Cancels the rendering. Finished numbered frames stay."));
            cancel.setMinWidth(USE_PREF_SIZE);
            cancel.setOnAction(_ -> stop.run());
            getStyleClass().add("reading");
            setAlignment(Pos.CENTER_LEFT);
            getChildren().addAll(bar, text, cancel);
            managedProperty().bind(visibleProperty());
            setVisible(false);
        }

        /** Shows the progress, as {@link RenderWindow#showProgress} does. */
        void show(String progress, Optional<Double> part) {
            text.setText(progress);
            bar.setProgress(part.orElse(ProgressBar.INDETERMINATE_PROGRESS));
            setVisible(true);
        }

        void hide() {
            // An invisible bar that moves would cost processor time.
            bar.setProgress(0);
            setVisible(false);
        }
    }
}
