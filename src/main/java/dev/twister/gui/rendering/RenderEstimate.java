package dev.twister.gui.rendering;

import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.render.RenderOrder;
import dev.twister.render.TimeLeft;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;

/** How much a rendering is, and how long it will take by the time of the window's picture. */
final class RenderEstimate {
    private RenderEstimate() {}

    /** Such as {@code 61 frames, 1,024 samples per pixel, about 2 h 10 min}; the most, if noise ends it earlier. */
    static String text(RenderOrder order, Optional<DrawnPicture> seen) {
        int frames = order.output().range().count();
        int samples = order.sampling().samples();
        String most = order.sampling().noise().isPresent() ? "at most " : "";
        return String.format(
                        Locale.ROOT,
                        "%s%s%,d %s per pixel",
                        frames == 1 ? "" : String.format(Locale.ROOT, "%,d frames, ", frames),
                        most,
                        samples,
                        samples == 1 ? "sample" : "samples")
                + seen.flatMap(picture -> time(order, picture))
                        .map(time -> (most.isEmpty() ? ", about " : ", up to about ") + TimeLeft.text(time))
                        .orElse("");
    }

    /** Empty where another engine or another kind of picture would be measured. */
    private static Optional<Duration> time(RenderOrder order, DrawnPicture seen) {
        boolean same =
                seen.request().engine().offer().id().equals(order.engine().id())
                        && seen.request().scene().rendering().integrator()
                                == order.scene().rendering().integrator()
                        && order.pictures().contains(seen.request().shown());
        double measured = (double) seen.frame().width()
                * seen.frame().height()
                * seen.input().samplesPerPixel();
        double ordered = (double) order.size().width()
                * order.size().height()
                * order.scene().rendering().samplesPerPixel()
                * order.output().range().count();
        return Optional.of(Duration.ofNanos((long) (seen.times().totalNanos() / measured * ordered)))
                .filter(time -> same && !time.isZero());
    }
}
