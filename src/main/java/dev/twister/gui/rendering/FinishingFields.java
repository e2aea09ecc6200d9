package dev.twister.gui.rendering;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import dev.twister.gui.controls.PlainBox;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.render.Background;
import dev.twister.render.Finishing;
import dev.twister.render.RenderOrder;
import dev.twister.render.Sampling;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javafx.application.Platform;
import javafx.scene.control.CheckBox;

/** What is done about noise, and which layers and background a file gets. */
final class FinishingFields {
    private final PlainBox<Double> noise;
    private final DenoiserChoice denoiser;
    private final CheckBox transparent = new CheckBox("transparent, in PNG and OpenEXR files");
    private final CheckBox lightLayers = new CheckBox("in OpenEXR files; File > View picture changes them");

    /** @param changed called when a person has chosen */
    FinishingFields(Runnable changed) {
        noise = new PlainBox<>("render-noise", RefinementGoal::noiseLabel, changed);
        noise.offer(RefinementGoal.NOISES, Optional.of(RefinementGoal.NO_NOISE));
        denoiser = new DenoiserChoice(changed);
        transparent.setId("render-transparent");
        transparent.setOnAction(_ -> changed.run());
        lightLayers.setId("render-light-layers");
        lightLayers.setOnAction(_ -> changed.run());
    }

    PlainBox<Double> noise() {
        return noise;
    }

    CheckBox denoiser() {
        return denoiser.box();
    }

    CheckBox transparent() {
        return transparent;
    }

    CheckBox lightLayers() {
        return lightLayers;
    }

    /** Looks for a denoiser in the background, once. */
    void look() {
        denoiser.look();
    }

    /** Offers what a file of the format can hold. */
    void follow(RenderFormat format) {
        lightLayers.setDisable(!format.hasLayers());
        transparent.setDisable(!format.hasAlpha());
    }

    /**
     * Why there can be no such order.
     *
     * @param color whether the picture has colors; numbers have no noise
     */
    Optional<String> complaint(int samples, boolean color) {
        return goal().filter(_ -> color && samples < Sampling.LEAST_CONVERGING)
                .map(_ -> "Samples per pixel is " + samples + ", but to stop at a noise, at least "
                        + Sampling.LEAST_CONVERGING + " are needed");
    }

    /** The order with the chosen noise, denoiser, layers and background, as far as its picture can have them. */
    RenderOrder applyTo(RenderOrder order, RenderFormat format) {
        boolean color = order.pictures().getFirst().isColor();
        Sampling sampling = new Sampling(order.sampling().samples(), goal().filter(_ -> color));
        boolean layers = format.hasLayers() && lightLayers.isSelected();
        boolean cut = format.hasAlpha()
                && transparent.isSelected()
                && order.pictures().stream().anyMatch(Finishing::isFull);
        return order.with(sampling, new Finishing(false, false, layers, denoiser.choice()))
                .over(cut ? Background.NONE : Background.SKY);
    }

    private Optional<Double> goal() {
        return noise.choice().filter(goal -> goal > 0);
    }

    /** Whether the noise of a picture is removed; off until a denoiser is found. */
    private static final class DenoiserChoice {
        private final CheckBox box = new CheckBox("looking for Open Image Denoise");
        private final Runnable changed;
        private Optional<DenoiserOffer> found = Optional.empty();
        private boolean asked;

        /** @param changed called when a person has chosen */
        DenoiserChoice(Runnable changed) {
            this.changed = changed;
            box.setId("render-denoise");
            box.setDisable(true);
            box.setOnAction(_ -> this.changed.run());
        }

        CheckBox box() {
            return box;
        }

        /** Looks for a denoiser in the background, once. */
        void look() {
            if (!asked) {
                asked = true;
                CompletableFuture<Void> _ = CompletableFuture.supplyAsync(Denoisers::offer)
                        .thenAccept(offer -> Platform.runLater(() -> show(offer)));
            }
        }

        private void show(DenoiserOffer offer) {
            found = Optional.of(offer).filter(DenoiserOffer::works);
            box.setDisable(found.isEmpty());
            box.setText(found.map(_ -> "with Open Image Denoise")
                    .orElse("needs Open Image Denoise, see 'twister devices'"));
        }

        /** The denoiser, if the noise is to be removed. */
        Optional<DenoiserOffer> choice() {
            return found.filter(_ -> box.isSelected());
        }
    }
}
