package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Denoising;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.util.List;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;

/** Settings of the picture: samples, exposure, tone mapping, and how it is refined at rest. */
final class PictureSection {
    private final List<PropertyRow> rows;
    private final SwitchRow refining;
    private final ChoiceRow<Double> noise;
    private final SwitchRow denoise;
    private final SwitchRow clipping;

    /** @param clippingShown whether clipped pixels are marked */
    PictureSection(Studio studio, BackgroundTasks tasks, BooleanProperty clippingShown) {
        rows = PropertyRow.following(
                Property.within(SceneProperties.RENDERING, Scene::rendering, Scene::withRendering), studio);
        refining = new SwitchRow(
                "Refine at rest",
                "Keep refining the picture while nothing moves.",
                "Alt+N",
                studio.refiningProperty()::set);
        noise = new ChoiceRow<>(
                "Stop at noise",
                "With path tracing: stop refining at this noise, an error in percent of white.",
                "",
                goal -> new Look(RefinementGoal.noiseLabel(goal)),
                studio.noiseGoalProperty()::set,
                studio::notice);
        denoise = new SwitchRow(
                "Denoise",
                "With path tracing: remove the noise, by Open Image Denoise where it is installed, else by a filter.",
                "",
                on -> setDenoising(on, studio, tasks));
        clipping = new SwitchRow("Show clipping", Command.CLIPPING.hint(), "Alt+Z", clippingShown::set);
        studio.refiningProperty().subscribe(on -> refining.show(on, true));
        studio.noiseGoalProperty().subscribe(goal -> noise.show(RefinementGoal.NOISES, goal, RefinementGoal.NO_NOISE));
        studio.denoiserProperty().subscribe(denoiser -> denoise.show(denoiser.isPresent(), true));
        clippingShown.subscribe(on -> clipping.show(on, false));
    }

    List<PanelRow> rows() {
        return Stream.concat(
                        rows.stream().map(PropertyRow::row), Stream.<PanelRow>of(refining, noise, denoise, clipping))
                .toList();
    }

    private static void setDenoising(boolean on, Studio studio, BackgroundTasks tasks) {
        if (on) {
            Denoising.start(studio, tasks, studio::notice);
        } else {
            Denoising.stop(studio);
        }
    }
}
