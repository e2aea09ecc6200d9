package dev.twister.gui.rendering;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.denoise.Denoisers;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javafx.application.Platform;
import javafx.scene.control.CheckBox;

/** Whether the noise of a picture is removed; off until a denoiser is found. */
final class DenoiserChoice {
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
        box.setText(
                found.map(_ -> "with Open Image Denoise").orElse("needs Open Image Denoise, see 'twister devices'"));
    }

    /** The denoiser, if the noise is to be removed. */
    Optional<DenoiserOffer> choice() {
        return found.filter(_ -> box.isSelected());
    }
}
