package dev.twister.gui.picture;

import dev.twister.engine.AutoExposure;
import dev.twister.engine.ExposureMeter;
import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.files.FileChoice;
import dev.twister.gui.files.FileNames;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrWriter;
import dev.twister.image.Frame;
import dev.twister.image.HdrWriter;
import dev.twister.image.PngWriter;
import java.io.IOException;
import java.nio.IntBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/** What is done with the picture that is shown: screenshots, recordings frame by frame, and the exposure by it. */
public final class PictureActions implements AutoCloseable {
    private final Studio studio;
    private final FileChoice choice;
    private final Dialogs dialogs;
    private final BackgroundTasks tasks;
    private final ReadOnlyObjectWrapper<Optional<FrameRecorder>> recorder =
            new ReadOnlyObjectWrapper<>(Optional.empty());

    /** The recordings that are over, but not all on the disk yet. */
    private final List<FrameRecorder> finishing = new ArrayList<>();

    private Path lastFolder = Path.of("").toAbsolutePath();
    private boolean finished;

    public PictureActions(Studio studio, FileChoice choice, Dialogs dialogs, BackgroundTasks tasks) {
        this.studio = studio;
        this.choice = choice;
        this.dialogs = dialogs;
        this.tasks = tasks;
    }

    /** The recording that is going on. */
    public ReadOnlyObjectProperty<Optional<FrameRecorder>> recorderProperty() {
        return recorder.getReadOnlyProperty();
    }

    /** Asks for a file, and saves the picture as it was when asked. */
    public void screenshot() {
        Optional<DrawnPicture> shown = studio.pictureProperty().get();
        if (shown.isEmpty()) {
            return;
        }
        Frame frame = shown.get().frame();
        int[] argb = frame.argb().clone();
        boolean srgb = shown.get().input().srgb();
        ShownRadiance radiance = ShownRadiance.of(studio, shown.get());
        choice.toSavePicture(lastFolder.resolve(FileNames.freeName(lastFolder))).ifPresent(file -> {
            lastFolder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(lastFolder);
            tasks.keepPicture(
                    // The window's engine may work long on a picture before it notices.
                    FileNames.isLinear(file) ? radiance.gathered() : CompletableFuture.completedFuture(""),
                    () -> {
                        write(file, argb, srgb, radiance);
                        return file;
                    },
                    written -> studio.notice("Saved " + written),
                    problem -> dialogs.complain("Couldn't save the picture", Dialogs.explain(problem)));
        });
    }

    /** Sets the exposure by the picture that is shown, once. */
    public void setExposure() {
        studio.pictureProperty().get().ifPresent(picture -> {
            if (picture.request().shown().isColor()) {
                measure(picture);
            } else {
                studio.notice(HistogramView.without(picture.request().shown()));
            }
        });
    }

    private void measure(DrawnPicture picture) {
        long document = studio.document().number();
        boolean srgb = studio.scene().rendering().srgb();
        CompletableFuture<Optional<float[]>> gathered = studio.radiance(picture);
        tasks.run(
                // A picture that was not refined has kept no radiance.
                () -> gathered.join()
                        .map(radiance -> AutoExposure.stops(radiance, srgb))
                        .orElseGet(() -> ExposureMeter.stops(picture.input())),
                stops -> {
                    if (studio.document().number() == document) {
                        setExposure(stops);
                    }
                },
                problem -> studio.notice(Dialogs.explain(problem)));
    }

    private void setExposure(OptionalDouble measured) {
        if (measured.isEmpty()) {
            studio.notice("The picture is black: its exposure can't be measured");
            return;
        }
        double stops = measured.getAsDouble();
        studio.endGesture();
        studio.editOnce("exposure", scene -> PropertyNumbers.EXPOSURE.write(scene, stops));
        studio.notice("Exposure: " + PropertyNumbers.EXPOSURE.scale().text(stops) + " stops");
    }

    /** Starts a recording, or ends the one that is going on. */
    public void toggleRecording() {
        if (recorder.get().isPresent()) {
            endRecording();
        } else {
            choice.folder(lastFolder).ifPresent(this::startRecording);
        }
    }

    /** Called in every pulse: says how a recording goes. */
    public void pulse() {
        recorder.get().ifPresent(running -> {
            FrameRecorder.Progress progress = running.progress();
            studio.notice(describe("Recording", progress));
            if (progress.failure().isPresent()) {
                endRecording();
            }
        });
        List<FrameRecorder> finished = finishing.stream()
                .filter(ended -> ended.progress().waiting() == 0)
                .toList();
        finishing.removeAll(finished);
        finished.forEach(ended -> {
            FrameRecorder.Progress progress = ended.progress();
            studio.notice(describe("Recorded", progress));
            progress.failure().ifPresent(why -> dialogs.complain("Recording stopped", why));
        });
    }

    /** Ends a recording, and begins no other. Returns at once. */
    public void finish() {
        finished = true;
        if (recorder.get().isPresent()) {
            endRecording();
        }
    }

    /** Waits until an ended recording's last frames are on the disk; called after {@link #finish}, by any thread. */
    @Override
    public void close() {
        finishing.forEach(FrameRecorder::close);
    }

    private void startRecording(Path folder) {
        lastFolder = folder;
        tasks.run(
                () -> FrameRecorder.start(folder),
                this::record,
                problem -> dialogs.complain("Couldn't start recording", Dialogs.explain(problem)));
    }

    private void record(FrameRecorder started) {
        // The window may have been closed while the folder was looked at.
        if (recorder.get().isEmpty() && !finished) {
            // At rest no other picture may come.
            studio.pictureProperty().get().ifPresent(shown -> record(started, shown));
            studio.watch(picture -> record(started, picture));
            recorder.set(Optional.of(started));
        } else {
            started.close();
        }
    }

    private void endRecording() {
        studio.unwatch();
        recorder.get().ifPresent(ended -> {
            ended.finish();
            finishing.add(ended);
        });
        recorder.set(Optional.empty());
    }

    private static void record(FrameRecorder running, DrawnPicture picture) {
        Frame frame = picture.frame();
        running.offer(
                frame.width(),
                frame.height(),
                IntBuffer.wrap(frame.argb()),
                picture.input().srgb());
    }

    private static String describe(String what, FrameRecorder.Progress progress) {
        String waiting = progress.waiting() == 0 ? "" : ", " + progress.waiting() + " waiting";
        return what + " " + progress.written() + " frames" + waiting;
    }

    private static void write(Path file, int[] argb, boolean srgb, ShownRadiance shown) throws IOException {
        int width = shown.width();
        int height = shown.height();
        if (FileNames.isExr(file)) {
            ExrWriter.write(file, width, height, channels(shown.await()));
        } else if (FileNames.isLinear(file)) {
            HdrWriter.write(file, width, height, shown.await());
        } else {
            PngWriter.write(file, width, height, argb, srgb);
        }
    }

    private static List<ExrChannel> channels(float[] radiance) {
        return List.of(
                new ExrChannel("R", radiance, 0, 3),
                new ExrChannel("G", radiance, 1, 3),
                new ExrChannel("B", radiance, 2, 3));
    }
}
