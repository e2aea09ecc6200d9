package dev.twister.bench;

import dev.twister.image.PictureSize;

/** One point of the paper's evaluation, for every engine. */
public record PaperSetting(PictureSize size, int shadowSamples, int bounces) {
    static PaperSetting of(Measurement measurement) {
        return new PaperSetting(measurement.size(), measurement.shadowSamples(), measurement.bounces());
    }

    @Override
    public String toString() {
        return size + ", " + ReportNumbers.counted(shadowSamples, "shadow sample") + ", "
                + ReportNumbers.counted(bounces, "bounce");
    }
}
