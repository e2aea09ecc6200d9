package dev.twister.bench;

import dev.twister.image.PictureSize;
import java.util.Map;
import java.util.Optional;

/** Results that the paper reports: "Accelerating Java Ray Tracing Applications on Heterogeneous Hardware". */
public final class PublishedFigures {
    /** The paper's title. */
    public static final String PAPER = "Accelerating Java Ray Tracing Applications on Heterogeneous Hardware";

    /** The paper's authors. */
    public static final String AUTHORS = "Pham Van, Fumero, Stratikopoulos, Blanaru, Kotselidis";

    /** The device of the paper's frame rates. */
    public static final String DEVICE = "RTX 2060";

    /** The paper's largest speedup over parallel streams, at 200 shadow samples and three bounces. */
    public static final double LARGEST_SPEEDUP_OVER_PARALLEL = 796;

    private static final Map<PictureSize, Double> FPS =
            Map.of(PictureSize.HD, 234.0, PictureSize.FULL_HD, 152.0, PictureSize.ULTRA_HD, 45.0);

    private PublishedFigures() {}

    /** Frames per second with hard shadows and one bounce on {@link #DEVICE}; empty for sizes that the paper lacks. */
    public static Optional<Double> fps(PictureSize size) {
        return Optional.ofNullable(FPS.get(size));
    }
}
