package dev.twister.bench;

import dev.twister.image.Frame;
import dev.twister.image.PictureSize;
import dev.twister.world.FrameInput;

/**
 * How an engine is measured.
 *
 * @param warmupFrames before the measured ones
 * @param frames measured ones
 * @param maxSeconds for both together, half of it at most for the former
 */
record EngineMeasuring(int warmupFrames, int frames, double maxSeconds, BenchmarkProgress progress) {
    /** Measures one engine with one input, and compares its picture with the reference. */
    Measurement measure(AskedEngine asked, FrameInput input, int[] reference) {
        Frame frame = Frame.ofPixels(input.width(), input.height());
        FrameLoop loop = new FrameLoop(asked.engine(), input, frame, progress, maxSeconds);
        int warmups = loop.warmUp(warmupFrames);
        MeasuredFrames measured = loop.measure(frames);
        return new Measurement(
                asked.id(),
                asked.device(),
                new PictureSize(input.width(), input.height()),
                input.shadowSamples(),
                input.bounces(),
                input.bodyCount(),
                warmups,
                measured.statistics(),
                measured.deviceTimes(),
                PictureComparison.of(reference, frame.argb()));
    }
}
