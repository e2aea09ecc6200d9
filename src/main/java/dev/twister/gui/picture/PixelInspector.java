package dev.twister.gui.picture;

import dev.twister.engine.JvmKernel;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.picking.PointerRay;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Studio;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.kernel.Layout;
import dev.twister.scene.Rgb;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.util.Locale;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;

/** Says what the pixel under the pointer is, over a corner of the picture. */
public final class PixelInspector extends HBox {
    private static final double SWATCH = 36;

    private final PictureView view;
    private final Studio studio;
    private final BackgroundTasks tasks;
    private final Rectangle swatch = new Rectangle(SWATCH, SWATCH);
    private final Label text = new Label();
    private Optional<Point2D> pointer = Optional.empty();
    private Optional<Asked> asked = Optional.empty();
    private boolean reading;

    /** A pixel of a picture. */
    private record Asked(long picture, int x, int y) {}

    public PixelInspector(PictureView view, Studio studio, BackgroundTasks tasks) {
        this.view = view;
        this.studio = studio;
        this.tasks = tasks;
        getStyleClass().add("inspector");
        setId("inspector");
        text.setId("inspector-text");
        text.setMinWidth(Region.USE_PREF_SIZE);
        setAlignment(Pos.CENTER_LEFT);
        setMouseTransparent(true);
        setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
        setVisible(false);
        getChildren().addAll(swatch, text);
        text.setText("Point at a pixel");
        view.addEventFilter(MouseEvent.MOUSE_MOVED, this::moved);
        view.addEventFilter(MouseEvent.MOUSE_DRAGGED, this::moved);
        view.addEventFilter(MouseEvent.MOUSE_EXITED, _ -> pointer = Optional.empty());
    }

    /** Called in every pulse. */
    public void pulse() {
        if (isVisible() && !reading) {
            studio.pictureProperty().get().ifPresent(this::read);
        }
    }

    private void moved(MouseEvent event) {
        pointer = Optional.of(new Point2D(event.getX(), event.getY()));
    }

    private void read(DrawnPicture picture) {
        pointer.filter(place -> view.place().contains(place.getX(), place.getY()))
                .map(place -> view.place().toPicture(place.getX(), place.getY()))
                .ifPresent(place -> read(
                        picture,
                        Math.clamp((int) place.getX(), 0, picture.frame().width() - 1),
                        Math.clamp((int) place.getY(), 0, picture.frame().height() - 1)));
    }

    private void read(DrawnPicture picture, int x, int y) {
        Asked wanted = new Asked(picture.number(), x, y);
        if (!asked.equals(Optional.of(wanted))) {
            asked = Optional.of(wanted);
            reading = true;
            int argb = picture.frame().argb()[y * picture.frame().width() + x];
            tasks.run(
                    () -> PixelReading.of(picture.input(), picture.samples(), x, y, argb),
                    pixel -> show(pixel, picture),
                    problem -> show(problem.toString()));
        }
    }

    private void show(PixelReading pixel, DrawnPicture picture) {
        swatch.setFill(Color.rgb(pixel.argb() >> 16 & 255, pixel.argb() >> 8 & 255, pixel.argb() & 255));
        show(pixel.text(picture.sceneBody(pixel.body()), picture.request().shown()));
    }

    private void show(String said) {
        text.setText(said);
        reading = false;
    }

    /**
     * What there is to know of a pixel.
     *
     * @param x from 0 at the left
     * @param y from 0 at the top
     * @param argb as it is shown
     * @param radiance linear, as the scalar kernel has it from the picture's own samples; the number itself in a view
     *     of numbers
     * @param body what the pixel's center shows, numbered as {@link BodyNumber} does
     * @param distance to it in meters; 0 for the sky
     * @param samples of the pixel
     */
    public record PixelReading(int x, int y, int argb, Rgb radiance, int body, double distance, int samples) {
        /** More take longer than one waits, and change no digit that is shown by much. */
        private static final int MOST_SAMPLES = 256;

        /**
         * Reads a pixel; takes as long as its samples take the scalar kernel.
         *
         * @param input of the picture
         * @param samples that the picture has gathered
         * @param argb that the pixel is shown as
         */
        public static PixelReading of(FrameInput input, int samples, int x, int y, int argb) {
            int read = Math.min(samples, MOST_SAMPLES);
            FrameInput sampled = read == input.samplesPerPixel() ? input : input.withSamples(0, read);
            Frame row = Frame.ofRadiance(input.width(), 1);
            new JvmKernel().drawRow(sampled.band(y, 1), FrameStop.of(row), 0, x, x + 1);
            PointerRay ray = PointerRay.through(input, x + 0.5, y + 0.5);
            return new PixelReading(
                    x,
                    y,
                    argb,
                    new Rgb(row.radiance()[3 * x], row.radiance()[3 * x + 1], row.radiance()[3 * x + 2]),
                    ray.body(),
                    ray.body() == Layout.NOTHING ? 0 : ray.distance(),
                    samples);
        }

        /**
         * What the inspector says of the
         *
         * @param sceneBody the body of the pixel, as the scene numbers it
         */
        String text(int sceneBody, StageOrView shown) {
            return String.format(
                    Locale.ROOT,
                    "x %d   y %d   RGB %d %d %d   #%06X%n%s%n%s   %d %s",
                    x,
                    y,
                    argb >> 16 & 255,
                    argb >> 8 & 255,
                    argb & 255,
                    argb & 0xFFFFFF,
                    value(radiance, shown),
                    sceneBody == BodyNumber.NONE
                            ? "sky"
                            : String.format(Locale.ROOT, "%s, %.3f m away", bodyName(sceneBody), distance),
                    samples,
                    samples == 1 ? "sample" : "samples");
        }

        /** A body as the scene numbers it. */
        static String bodyName(int body) {
            if (BodyNumber.mesh(body) < 0 && BodyNumber.light(body) > 0) {
                return "light " + (BodyNumber.light(body) + 1);
            }
            return switch (body) {
                case BodyNumber.NONE -> "sky";
                case BodyNumber.LIGHT -> "light";
                case BodyNumber.PLANE -> "plane";
                default ->
                    BodyNumber.mesh(body) >= 0
                            ? "mesh " + (BodyNumber.mesh(body) + 1)
                            : "sphere " + (BodyNumber.sphere(body) + 1);
            };
        }

        private static String value(Rgb value, StageOrView shown) {
            String name = shown.isColor() ? "radiance" : shown.id();
            return shown.isNumber()
                    ? String.format(Locale.ROOT, "%s %.5g", name, value.red())
                    : String.format(Locale.ROOT, "%s %.5f %.5f %.5f", name, value.red(), value.green(), value.blue());
        }
    }
}
