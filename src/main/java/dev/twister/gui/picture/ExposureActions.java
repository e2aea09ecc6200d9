package dev.twister.gui.picture;

import dev.twister.engine.AutoExposure;
import dev.twister.engine.ExposureMeter;
import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;

/** Sets the exposure by the picture that is shown, once. */
public final class ExposureActions {
    private final Studio studio;
    private final BackgroundTasks tasks;

    public ExposureActions(Studio studio, BackgroundTasks tasks) {
        this.studio = studio;
        this.tasks = tasks;
    }

    public void setAutomatically() {
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
                        set(stops);
                    }
                },
                problem -> studio.notice(Dialogs.explain(problem)));
    }

    private void set(OptionalDouble measured) {
        if (measured.isEmpty()) {
            studio.notice("The picture is black: its exposure can't be measured");
            return;
        }
        double stops = measured.getAsDouble();
        studio.endGesture();
        studio.edit("exposure", scene -> PropertyNumbers.EXPOSURE.write(scene, stops));
        studio.endGesture();
        studio.notice("Exposure: " + PropertyNumbers.EXPOSURE.scale().text(stops) + " stops");
    }
}
