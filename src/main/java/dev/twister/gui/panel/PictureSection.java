package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.property.SceneNumbers;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Denoising;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Integrator;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.ToneMap;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;

/** Settings of the picture: samples, exposure, tone mapping. */
final class PictureSection {
    private final Studio studio;
    private final List<NumberRow> numbers;
    private final ChoiceRow<Integrator> integrator;
    private final ChoiceRow<ToneMap> toneMap;
    private final SwitchRow srgb;
    private final SwitchRow refining;
    private final SwitchRow clipping;
    private final RestRows rest;

    /** @param clippingShown whether clipped pixels are marked */
    PictureSection(Studio studio, BackgroundTasks tasks, BooleanProperty clippingShown) {
        this.studio = studio;
        numbers = NumberRow.of(SceneNumbers.PICTURE, studio);
        integrator = new ChoiceRow<>(
                "Integrator",
                "Real time: reflections and one light's shadows. Path tracing: light from everywhere, refined at rest.",
                "Alt+Shift+V",
                choice -> new Look(label(choice)),
                choice -> edit("integrator", settings -> settings.withIntegrator(choice)),
                studio::notice);
        toneMap = new ChoiceRow<>(
                "Tone map",
                "Maps bright colors to the range that a screen can show.",
                "Alt+T",
                map -> new Look(label(map)),
                this::setToneMap,
                studio::notice);
        srgb = new SwitchRow(
                "sRGB curve", "Apply the sRGB transfer function after tone mapping.", "Alt+U", this::setSrgb);
        refining = new SwitchRow(
                "Refine at rest",
                "Keep refining the picture while nothing moves.",
                "Alt+N",
                studio.refiningProperty()::set);
        clipping = new SwitchRow("Show clipping", Command.CLIPPING.hint(), "Alt+Z", clippingShown::set);
        rest = new RestRows(studio, tasks);
        clippingShown.subscribe(on -> clipping.show(on, false));
        studio.sceneProperty().subscribe(_ -> refresh());
        studio.document().originalProperty().subscribe(_ -> refresh());
        studio.refiningProperty().subscribe(on -> refining.show(on, true));
    }

    List<PanelRow> rows() {
        return Stream.of(numbers, List.of(integrator, toneMap, srgb, refining), rest.rows(), List.of(clipping))
                .<PanelRow>flatMap(List::stream)
                .toList();
    }

    private void refresh() {
        Scene scene = studio.scene();
        Scene usual = studio.document().original();
        numbers.forEach(row -> row.show(scene, usual));
        integrator.show(
                List.of(Integrator.values()),
                scene.rendering().integrator(),
                usual.rendering().integrator());
        toneMap.show(
                List.of(ToneMap.values()),
                scene.rendering().toneMap(),
                usual.rendering().toneMap());
        srgb.show(scene.rendering().srgb(), usual.rendering().srgb());
    }

    private static String label(Integrator integrator) {
        return switch (integrator) {
            case WHITTED -> "Real time";
            case PATH -> "Path tracing";
        };
    }

    private static String label(ToneMap map) {
        return switch (map) {
            case CLAMP -> "Clamp";
            case REINHARD -> "Reinhard";
            case ACES -> "ACES";
        };
    }

    private void setToneMap(ToneMap map) {
        edit("tone map", settings -> settings.withTone(settings.exposure(), map, settings.srgb()));
    }

    private void setSrgb(boolean on) {
        edit("sRGB curve", settings -> settings.withTone(settings.exposure(), settings.toneMap(), on));
    }

    private void edit(String what, UnaryOperator<Rendering> change) {
        studio.edit(what, scene -> scene.withRendering(change.apply(scene.rendering())));
        studio.endGesture();
    }

    /** How long a path-traced picture at rest is refined, and whether its noise is removed. */
    private static final class RestRows {
        private final Studio studio;
        private final BackgroundTasks tasks;
        private final ChoiceRow<Double> noise;
        private final SwitchRow denoise;

        RestRows(Studio studio, BackgroundTasks tasks) {
            this.studio = studio;
            this.tasks = tasks;
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
                    this::setDenoising);
            studio.noiseGoalProperty()
                    .subscribe(goal -> noise.show(RefinementGoal.NOISES, goal, RefinementGoal.NO_NOISE));
            studio.denoiserProperty().subscribe(denoiser -> denoise.show(denoiser.isPresent(), false));
        }

        List<PanelRow> rows() {
            return List.of(noise, denoise);
        }

        private void setDenoising(boolean on) {
            if (on) {
                Denoising.start(studio, tasks, studio::notice);
            } else {
                Denoising.stop(studio);
            }
        }
    }
}
