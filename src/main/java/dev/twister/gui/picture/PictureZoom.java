package dev.twister.gui.picture;

/**
 * The visible part of a picture and its magnification, relative to the size at which all of it fits.
 *
 * @param factor 1 if the picture fits the view, up to {@value #MOST}
 * @param centerX what is seen in the view's middle, as a share of the picture's width
 * @param centerY the same of its height
 */
public record PictureZoom(double factor, double centerX, double centerY) {
    public static final double MOST = 128;

    /** All of the picture. */
    public static final PictureZoom FIT = new PictureZoom(1, 0.5, 0.5);

    /** So near to 1, it is meant to fit. */
    private static final double LEAST = 1.01;

    /**
     * One axis of the view: the fitted picture's length along it, and the view's.
     *
     * @param fitted above 0
     * @param view above 0
     */
    public record Side(double fitted, double view) {
        private double start(double factor, double center) {
            double length = fitted * factor;
            double start = view / 2 - center * length;
            return length <= view ? (view - length) / 2 : Math.clamp(start, view - length, 0);
        }

        /** The center at which the share lies at that place of the view. */
        private double center(double factor, double share, double place) {
            return share + (view / 2 - place) / (fitted * factor);
        }

        private double share(double factor, double center, double place) {
            return (place - start(factor, center)) / (fitted * factor);
        }
    }

    public boolean isFit() {
        return factor == 1;
    }

    /** Where the picture begins in the view; it leaves no room that it can fill. */
    public double left(Side across) {
        return across.start(factor, centerX);
    }

    public double top(Side down) {
        return down.start(factor, centerY);
    }

    /** So many times larger or smaller; what lies at a place of the view stays there, as far as it can. */
    public PictureZoom times(double change, Side across, double x, Side down, double y) {
        double zoomed = Math.clamp(factor * change, 1, MOST);
        if (zoomed < LEAST) {
            return FIT;
        }
        return new PictureZoom(
                zoomed,
                across.center(zoomed, across.share(factor, centerX, x), x),
                down.center(zoomed, down.share(factor, centerY, y), y));
    }

    /** The picture moved with the pointer, up to its border. */
    public PictureZoom moved(Side across, double right, Side down, double lower) {
        return new PictureZoom(
                factor,
                across.share(factor, centerX, across.view() / 2 - right),
                down.share(factor, centerY, down.view() / 2 - lower));
    }
}
