package dev.twister.bench.device;

import dev.twister.bench.benchmark.PictureComparison;

/** A picture of a check, compared with the reference's. */
record CheckedPicture(String name, PictureComparison comparison) {
    /** Its name and the number of differing pixels. */
    String difference() {
        return name + " " + comparison.differingPixels() + " of " + comparison.pixels() + " ("
                + comparison.allowedPixels() + " may)";
    }
}
