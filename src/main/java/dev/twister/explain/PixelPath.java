package dev.twister.explain;

import dev.twister.engine.JvmKernel;
import dev.twister.explain.PathRecorder.Floats;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.kernel.Views;
import dev.twister.scene.Rgb;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * The path of one sample of a pixel, as the kernel follows it.
 *
 * @param column of the pixel, from 0 at the left
 * @param row from 0 at the top
 * @param sample from 0
 * @param samples of the pixel
 * @param lights the lights' bodies
 * @param isTraced whether the integrator is {@code path}
 * @param steps in the order in which the kernel follows the rays; the view ray is the first
 * @param radiance of the sample: what the steps add, as floats added one after the other
 * @param pixel the mean of all samples' radiance
 * @param argb the pixel as it is shown, 0xAARRGGBB
 */
public record PixelPath(
        int column,
        int row,
        int sample,
        int samples,
        List<Integer> lights,
        boolean isTraced,
        List<PathStep> steps,
        Rgb radiance,
        Rgb pixel,
        int argb) {
    /**
     * Follows a sample's path; of the picture itself, where the input is of a view.
     *
     * @throws IndexOutOfBoundsException where the picture has no such pixel, or the pixel no such sample
     */
    public static PixelPath of(FrameInput input, int column, int row, int sample) {
        Objects.checkIndex(column, input.width());
        Objects.checkIndex(row, input.height());
        Objects.checkIndex(sample, input.samplesPerPixel());
        FrameInput full = input.stageOrView() == Views.FULL ? input : input.showing(StageOrView.BEAUTY);
        FrameInput band = full.band(row, 1);
        boolean traced = (band.variant(false) & Variant.PATH) != 0;
        List<PathStep> steps =
                traced ? new TraceRecorder(band).record(column, sample) : new PathRecorder(band).record(column, sample);
        Frame linear = Frame.ofRadiance(input.width(), 1);
        Frame shown = Frame.ofPixels(input.width(), 1);
        new JvmKernel().drawRow(band, FrameStop.of(linear), 0, column, column + 1);
        new JvmKernel().drawRow(band, FrameStop.of(shown), 0, column, column + 1);
        return new PixelPath(
                column,
                row,
                sample,
                input.samplesPerPixel(),
                IntStream.range(0, input.lights()).mapToObj(input::light).toList(),
                traced,
                steps,
                sum(steps),
                Floats.rgb(linear.radiance(), 3 * column),
                shown.argb()[column]);
    }

    /** Such as {@code sky}, {@code light}, {@code light 2}, {@code plane} or {@code body 5}. */
    public String bodyName(int body) {
        int light = lights.indexOf(body);
        return switch (body) {
            case Layout.NOTHING -> "sky";
            case Layout.LIGHT -> "light";
            case Layout.PLANE -> "plane";
            default -> light < 0 ? "body " + body : light == 0 ? "light" : "light " + (light + 1);
        };
    }

    /** Red (0), green (1) or blue (2) of the pixel as it is shown, in [0, 255]. */
    public int shown(int channel) {
        return argb >> (16 - 8 * channel) & 0xFF;
    }

    private static Rgb sum(List<PathStep> steps) {
        float[] sum = new float[3];
        for (PathStep step : steps) {
            sum[0] += (float) step.adds().red();
            sum[1] += (float) step.adds().green();
            sum[2] += (float) step.adds().blue();
        }
        return Floats.rgb(sum, 0);
    }
}
