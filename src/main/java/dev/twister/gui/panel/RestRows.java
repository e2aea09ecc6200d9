package dev.twister.gui.panel;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.gui.controls.Problems;
import dev.twister.gui.drawing.NoiseGoal;
import dev.twister.gui.panel.ChoiceRow.Look;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import java.util.List;
import java.util.Optional;

/** How long a path-traced picture at rest is refined, and whether its noise is removed. */
final class RestRows {
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
                goal -> new Look(NoiseGoal.label(goal)),
                studio.noiseGoalProperty()::set,
                studio::notice);
        denoise = new SwitchRow(
                "Denoise",
                "With path tracing: remove the noise of a picture at rest by Open Image Denoise.",
                "",
                this::setDenoising);
        studio.noiseGoalProperty().subscribe(goal -> noise.show(NoiseGoal.ALL, goal, NoiseGoal.NONE));
        studio.denoiserProperty().subscribe(denoiser -> denoise.show(denoiser.isPresent(), false));
    }

    List<PanelRow> rows() {
        return List.of(noise, denoise);
    }

    private void setDenoising(boolean on) {
        if (on) {
            // Off until the library is found, which takes some 0.5 s.
            tasks.run(Denoisers::offer, this::use, problem -> studio.notice(Problems.explain(problem)));
        } else {
            studio.denoiserProperty().set(Optional.empty());
        }
    }

    private void use(DenoiserOffer offer) {
        studio.denoiserProperty().set(Optional.of(offer).filter(DenoiserOffer::works));
        denoise.show(offer.works(), false);
        offer.obstacle().ifPresent(studio::notice);
    }
}
