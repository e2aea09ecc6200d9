package dev.twister.gui.panel;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.Comparison.Mode;
import dev.twister.gui.picture.HistogramView;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Denoising;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Studio;
import dev.twister.scene.Scene;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import dev.twister.world.StageOrView;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;

/** The sections about how the scene is drawn: by which engine, how fine and bright, and beside which second picture. */
final class DrawingSections {
    private static final String SAME = "as the first";

    private DrawingSections() {}

    /** The engine, the resolution and the shown stage or view. */
    static PanelSection drawing(Studio studio, EngineList engines, String usualEngine) {
        ChoiceRow<String> engine = new ChoiceRow<>(
                "Engine",
                "The engine that renders. Engines that do not work here say why.",
                "Alt+G",
                id -> engines.find(id).map(DrawingSections::look).orElseGet(() -> unknown(id)),
                id -> engines.find(id).ifPresent(studio::chooseEngine),
                studio::notice);
        engine.firstControl().focusedProperty().subscribe(focused -> {
            if (focused) {
                engines.want();
            }
        });
        Runnable show = () -> {
            String chosen = studio.engineProperty().get().offer().id();
            List<String> ids =
                    Stream.concat(ids(engines), Stream.of(chosen)).distinct().toList();
            engine.show(ids, chosen, ids.contains(usualEngine) ? usualEngine : chosen);
        };
        engines.offersProperty().subscribe(_ -> show.run());
        studio.engineProperty().subscribe(_ -> show.run());
        ChoiceRow<ResolutionMode> resolution = new ChoiceRow<>(
                "Resolution",
                "Pixels to render; the picture is scaled to fit the window.",
                "Alt+R",
                mode -> new Look(mode.label()),
                studio::setResolution,
                studio::notice);
        resolution.follow(studio.resolutionProperty(), List.of(ResolutionMode.values()), ResolutionMode.WINDOW);
        ChoiceRow<StageOrView> shown = new ChoiceRow<>(
                "Show",
                "The full picture, a stage on the way to it, or values per pixel.",
                "Alt+J",
                picture -> new Look(
                        StagesAndViews.label(picture),
                        StagesAndViews.label(picture),
                        StagesAndViews.hint(picture),
                        Optional.empty()),
                studio::setShown,
                studio::notice);
        shown.follow(studio.shownProperty(), StagesAndViews.all(), StageOrView.BEAUTY);
        return new PanelSection("Drawing", engine, resolution, shown);
    }

    private static Look look(EngineOffer offer) {
        String device = offer.device().isEmpty() ? "" : " (" + offer.device() + ")";
        return new Look(offer.id() + device, offer.id(), offer.description(), offer.obstacle());
    }

    /**
     * An engine that was asked for by a name that is not in the list: the first device of a family, or one that does
     * not exist.
     */
    private static Look unknown(String id) {
        return Engines.deviceFamilies().contains(id)
                ? new Look(id)
                : new Look(id, id, "", Optional.of("there is no engine of this name here"));
    }

    private static Stream<String> ids(EngineList engines) {
        return engines.offersProperty().get().stream().map(EngineOffer::id);
    }

    /**
     * Samples, exposure, tone mapping, and how the picture is refined at rest.
     *
     * @param clippingShown whether clipped pixels are marked
     */
    static PanelSection picture(
            Studio studio, BackgroundTasks tasks, BooleanProperty clippingShown, HistogramView histogram) {
        SwitchRow refining = new SwitchRow(
                "Refine at rest",
                "Keep refining the picture while nothing moves.",
                "Alt+N",
                studio.refiningProperty()::set);
        refining.follow(studio.refiningProperty(), true);
        ChoiceRow<Double> noise = new ChoiceRow<>(
                "Stop at noise",
                "With path tracing: stop refining at this noise, an error in percent of white.",
                "",
                goal -> new Look(RefinementGoal.noiseLabel(goal)),
                studio.noiseGoalProperty()::set,
                studio::notice);
        noise.follow(studio.noiseGoalProperty(), RefinementGoal.NOISES, RefinementGoal.NO_NOISE);
        SwitchRow denoise = new SwitchRow(
                "Denoise",
                "With path tracing: remove the noise, by Open Image Denoise where it is installed, else by a filter.",
                "",
                on -> setDenoising(on, studio, tasks));
        denoise.follow(studio.denoiserProperty().map(Optional::isPresent), true);
        SwitchRow clipping = new SwitchRow("Show clipping", Command.CLIPPING.hint(), "Alt+Z", clippingShown::set);
        clipping.follow(clippingShown, false);
        List<PanelRow> rows = new ArrayList<>(PropertyRow.following(
                Property.within(SceneProperties.RENDERING, Scene::rendering, Scene::withRendering), studio));
        rows.addAll(List.of(refining, noise, denoise, clipping));
        return new PanelSection("Picture", rows, histogram);
    }

    private static void setDenoising(boolean on, Studio studio, BackgroundTasks tasks) {
        if (on) {
            Denoising.start(studio, tasks, studio::notice);
        } else {
            Denoising.stop(studio);
        }
    }

    /** What the second picture shows, if there is one. */
    static PanelSection compare(Studio studio, EngineList engines, Comparison comparison) {
        ChoiceRow<Mode> mode = new ChoiceRow<>(
                "Second picture",
                "Shows a second picture to the right of a divider, or the difference of both, 16 times as bright.",
                "Alt+Shift+B",
                now -> new Look(now.name().toLowerCase(Locale.ROOT)),
                comparison.modeProperty()::set,
                studio::notice);
        mode.follow(comparison.modeProperty(), List.of(Mode.values()), Mode.OFF);
        ChoiceRow<String> engine = new ChoiceRow<>(
                "Its engine",
                "The engine of the second picture.",
                "Alt+Shift+G",
                id -> engines.find(id)
                        .map(offer -> new Look(id, id, offer.description(), offer.obstacle()))
                        .orElseGet(() -> new Look(id)),
                id -> comparison.engineProperty().set(engines.find(id)),
                studio::notice);
        Runnable show = () -> engine.show(
                Stream.concat(Stream.of(SAME), ids(engines)).toList(),
                comparison.engineProperty().get().map(EngineOffer::id).orElse(SAME),
                SAME);
        engines.offersProperty().subscribe(_ -> show.run());
        comparison.engineProperty().subscribe(_ -> show.run());
        ChoiceRow<Optional<StageOrView>> shown = new ChoiceRow<>(
                "It shows",
                "The stage or view of the second picture.",
                "Alt+Shift+S",
                picture -> new Look(picture.map(StagesAndViews::label).orElse(SAME)),
                comparison.shownProperty()::set,
                studio::notice);
        shown.follow(
                comparison.shownProperty(),
                Stream.concat(
                                Stream.of(Optional.<StageOrView>empty()),
                                StagesAndViews.all().stream().map(Optional::of))
                        .toList(),
                Optional.empty());
        SwitchRow settings = new SwitchRow(
                "Keep settings",
                "The second picture keeps the settings under Picture as they are now, while you change those of the first.",
                "Alt+Shift+K",
                on -> comparison
                        .settingsProperty()
                        .set(Optional.of(studio.scene().rendering()).filter(_ -> on)));
        settings.follow(comparison.settingsProperty().map(Optional::isPresent), false);
        return new PanelSection("Compare", mode, engine, shown, settings);
    }
}
