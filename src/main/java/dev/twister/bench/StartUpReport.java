package dev.twister.bench;

import java.time.Duration;

/**
 * How one process started.
 *
 * @param firstEngine the engine that drew the first frame
 * @param firstFrame from the start of the process to the end of the first frame
 * @param lastEngine the engine that drew the last frame
 * @param fullFrame what a frame took at full speed: the best median of a hundred frames one after the other
 * @param fullSpeed from the start of the process to the first of five frames that, at the median, reached nine tenths of
 *     the frames a second at full speed
 * @param frames how many were drawn
 */
public record StartUpReport(
        String firstEngine,
        Duration firstFrame,
        String lastEngine,
        Duration fullFrame,
        Duration fullSpeed,
        int frames) {}
