package dev.twister.render;

import dev.twister.world.FrameInput;
import java.util.List;
import java.util.Optional;

/**
 * What a rendering did.
 *
 * @param kept number of frames of an earlier run that were kept
 * @param samples of the pictures that were rendered, if there was a noise bound
 * @param picture empty for frames and films
 */
public record RenderResult(int kept, SampleTotals samples, Optional<Single> picture) {
    /**
     * A single picture.
     *
     * @param part the rows and samples that were rendered
     * @param engine its id
     * @param device its display name
     */
    public record Single(List<RenderedView> drawn, FrameInput part, String engine, String device) {}
}
