package dev.twister.bench.results;

import dev.twister.image.PictureSize;
import java.util.Map;

/**
 * What one engine reached on one machine, with one scene and quality.
 *
 * @param machine its processor
 * @param device what the engine ran on
 * @param quality shadow samples and bounces, or paths per pixel
 * @param made version of Twister and the day of the measurement
 * @param log the report's file in the page's folder
 * @param fps frames per second by size
 */
record ResultRow(
        String machine,
        String device,
        String engine,
        String scene,
        String quality,
        String made,
        String log,
        Map<PictureSize, Double> fps) {
    /** Whether the paper measured the same scene with the same quality. */
    boolean isOfThePaper() {
        return scene.equals("benchmark") && quality.equals("1/1");
    }
}
