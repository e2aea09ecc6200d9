package dev.twister.oracle;

import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.StageOrView;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** Renders scenes by evaluating the design's equations directly. */
public final class Oracle {
    /** The plastic number, the real root of x^3 = x + 1, which generates Roberts's R2 sequence. */
    private static final double PLASTIC = 1.324717957244746;

    /** Perturbations: zero, and two, four and sixteen float roundings in either direction. */
    private static final double[] GROWTHS = {
        1 - 0x1p-20, 1 - 0x1p-22, 1 - 0x1p-23, 1, 1 + 0x1p-23, 1 + 0x1p-22, 1 + 0x1p-20
    };

    /** Radius perturbations: two roundings inward, none, two outward. */
    private static final double[] LIFTS = {-0x1p-23, 0, 0x1p-23};

    /** Largest tilt of rough surfaces' facets: the kernel's sines are within 4e-7. */
    private static final double TILT = 2e-7;

    /** Relative rounding error of the throughput of a path with many surfaces. */
    private static final double CUT = 0x1p-19;

    private final Scene rounded;
    private final SceneImages images;
    private final SceneMeshes meshes;
    private final OracleTracer tracer;
    private final OracleCamera camera;
    private final OracleTone tone;
    private final RayMoves moves;
    private final int width;
    private final int height;
    private final int samplesPerPixel;

    public Oracle(Scene scene, Skybox sky) {
        this(new LitScene(scene, sky));
    }

    public Oracle(LitScene litScene) {
        Scene scene = litScene.scene();
        rounded = FloatScene.of(scene);
        images = litScene.images();
        meshes = litScene.meshes();
        width = scene.rendering().width();
        height = scene.rendering().height();
        samplesPerPixel = scene.rendering().samplesPerPixel();
        tracer = new OracleTracer(rounded, images, meshes, Rounding.NONE);
        camera = new OracleCamera(rounded.camera(), width, height);
        tone = new OracleTone(scene.rendering());
        moves = new RayMoves();
    }

    /** Returns a pixel's linear color, before exposure and tone mapping. */
    public Rgb radiance(int column, int row) {
        Color average = average(column, row);
        return new Rgb(average.red(), average.green(), average.blue());
    }

    /** Returns the value of a stage without reflections, or of a view, with the scene's own shadows. */
    Color value(int column, int row, StageOrView picture) {
        Color sum = Color.BLACK;
        for (ViewRay ray : viewRays(column, row, 0)) {
            sum = sum.plus(tracer.value(ray, picture));
        }
        return sum.times(1.0 / samplesPerPixel);
    }

    /** Returns a pixel as 0xAARRGGBB. */
    public int argb(int column, int row) {
        return tone.argb(average(column, row));
    }

    /** Returns all pixels as 0xAARRGGBB, in row-major order from the top. */
    public int[] picture() {
        return IntStream.range(0, width * height)
                .parallel()
                .map(pixel -> argb(pixel % width, pixel / width))
                .toArray();
    }

    /**
     * Returns the range of a pixel's color under perturbations of sample positions, view rays and sphere radii by a few
     * float roundings. The range is wide at edges or where mirrors amplify, and empty elsewhere. Radii matter for
     * spheres as large as a planet: near their surface, distances are small differences of large numbers. So do points
     * on them, and all perturbations combined: where a planet emerges from the plane, rounding may hit the planet just
     * below the plane, which then reflects the plane.
     */
    PixelSpan span(int column, int row) {
        Color lowest = Color.BLACK;
        Color highest = Color.BLACK;
        double step = Math.ulp((float) Math.max(width, height));
        List<OracleTracer> roundings = roundedTracers();
        List<ViewRay> rays = viewRays(column, row, 0);
        List<ViewRay> lefts = viewRays(column, row, -step);
        List<ViewRay> rights = viewRays(column, row, step);
        for (int i = 0; i < rays.size(); i++) {
            Color low = tracer.color(rays.get(i));
            Color high = low;
            List<Ray> movedRays = moves.of(rays.get(i).ray());
            movedRays.add(rays.get(i).ray());
            movedRays.add(lefts.get(i).ray());
            movedRays.add(rights.get(i).ray());
            for (OracleTracer rounding : roundings) {
                for (Ray moved : movedRays) {
                    Color color = rounding.color(rays.get(i).with(moved));
                    low = low.min(color);
                    high = high.max(color);
                }
            }
            lowest = lowest.plus(low);
            highest = highest.plus(high);
        }
        double share = 1.0 / samplesPerPixel;
        return new PixelSpan(tone.argb(lowest.times(share)), tone.argb(highest.times(share)));
    }

    private List<OracleTracer> roundedTracers() {
        Random random = new Random(2);
        List<OracleTracer> tracers = new ArrayList<>();
        for (double factor : GROWTHS) {
            Scene grown = FloatScene.grown(rounded, factor);
            for (double lift : LIFTS) {
                Vector tilt =
                        new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).times(TILT);
                double cut = 1 + Math.signum(lift) * CUT;
                tracers.add(new OracleTracer(grown, images, meshes, new Rounding(lift, tilt, cut)));
            }
        }
        return tracers;
    }

    private Color average(int column, int row) {
        Color sum = Color.BLACK;
        for (ViewRay ray : viewRays(column, row, 0)) {
            sum = sum.plus(tracer.color(ray));
        }
        return sum.times(1.0 / samplesPerPixel);
    }

    /**
     * Returns points of the R2 sequence with their mirror images through the center, plus the center for odd numbers.
     *
     * @param step offset of all points, to the right and down
     */
    private List<ViewRay> viewRays(int column, int row, double step) {
        List<ViewRay> rays = new ArrayList<>();
        if (samplesPerPixel % 2 == 1) {
            rays.add(viewRay(column, row, 0, step + 0.5, step + 0.5));
        }
        for (int point = 1; point <= samplesPerPixel / 2; point++) {
            double x = rounded(0.5 + point / PLASTIC);
            double y = rounded(0.5 + point / (PLASTIC * PLASTIC));
            rays.add(viewRay(column, row, 2 * point - 1, step + x, step + y));
            rays.add(viewRay(column, row, 2 * point, step + (1 - x), step + (1 - y)));
        }
        return rays;
    }

    private ViewRay viewRay(int column, int row, int item, double x, double y) {
        return camera.ray(column + x, row + y, new SampleNumbers(column, row, item));
    }

    /** Returns the fraction rounded to a float, as for engines. */
    private static double rounded(double value) {
        return Math.rint((value - Math.floor(value)) * 0x1p24) / 0x1p24;
    }
}
