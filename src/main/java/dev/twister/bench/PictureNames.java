package dev.twister.bench;

/** Sizes as people call them. */
final class PictureNames {
    private PictureNames() {}

    static String of(PictureSize size) {
        if (size.equals(PictureSize.HD)) {
            return "720p";
        }
        if (size.equals(PictureSize.FULL_HD)) {
            return "1080p";
        }
        return size.equals(PictureSize.ULTRA_HD) ? "4K" : size.toString();
    }
}
