package dev.twister.bench;

/** A picture of a check beside the reference's. */
record CheckedPicture(String name, PictureComparison comparison) {
    /** Its name with how many pixels are off. */
    String difference() {
        return name + " " + comparison.differingPixels() + " of " + comparison.pixels() + " ("
                + comparison.allowedPixels() + " may)";
    }
}
