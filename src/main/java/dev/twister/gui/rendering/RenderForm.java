package dev.twister.gui.rendering;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.film.Ffmpeg;
import dev.twister.gui.controls.NumberField;
import dev.twister.gui.controls.PlainBox;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.drawing.RefinementGoal;
import dev.twister.gui.drawing.StagesAndViews;
import dev.twister.gui.rendering.WindowOrder.MovingScene;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Studio;
import dev.twister.image.PictureSize;
import dev.twister.render.PictureMemory;
import dev.twister.render.RenderOrder;
import dev.twister.render.Renderer;
import dev.twister.render.TimeLeft;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.property.SceneProperties;
import dev.twister.scene.select.VisibleBodies;
import dev.twister.world.FrameInput;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.RadioButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;

/** The form of the render window; it keeps its values. */
final class RenderForm extends GridPane {
    private final Studio studio;
    private final EngineList engines;
    private final boolean mp4 =
            Ffmpeg.find(System.getenv().getOrDefault("PATH", "")).isPresent();
    private final ReadOnlyObjectWrapper<Optional<String>> complaint = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final RadioButton film = radio("render-film", "Fil_m");
    private final FilmFields films = new FilmFields(this::check);
    private final SizeFields size = new SizeFields(this::check);
    private final NumberField samples =
            new NumberField("Samples per pixel", SceneProperties.SAMPLES_PER_PIXEL.range(), true, this::check);
    private final NumberField shadows =
            new NumberField("Shadow samples", SceneProperties.SHADOW_SAMPLES.range(), true, this::check);
    private final PlainBox<EngineOffer> engine = new PlainBox<>("render-engine", RenderForm::name, this::check);
    private final PlainBox<StageOrView> shown = new PlainBox<>("render-show", StagesAndViews::label, this::check);
    private final PlainBox<RenderFormat> format = new PlainBox<>("render-format", RenderFormat::label, this::check);
    private final Label estimate = new Label();
    private final FinishingFields finishing = new FinishingFields(this::check);
    private Optional<Long> document = Optional.empty();
    private int rows;

    RenderForm(Studio studio, EngineList engines) {
        this.studio = studio;
        this.engines = engines;
        getStyleClass().add("render-form");
        ColumnConstraints controls = new ColumnConstraints();
        controls.setHgrow(Priority.ALWAYS);
        getColumnConstraints().setAll(new ColumnConstraints(), controls);
        RadioButton picture = radio("render-picture", "_Picture");
        picture.setSelected(true);
        ToggleGroup group = new ToggleGroup();
        group.getToggles().setAll(picture, film);
        HBox output = new HBox(picture, film);
        output.getStyleClass().add("render-choice");
        addRow("Output", output, picture);
        showForFilms(addRow("M_oves", films.motion(), films.motion()));
        showForFilms(addRow("Frames per secon_d", films.rate(), films.rate()));
        showForFilms(addRow("Fr_ames", films.frames(), films.first()));
        addRow("Si_ze", size, size.firstControl());
        addRow("_Samples per pixel", samples, samples);
        addRow("S_hadow samples", shadows, shadows);
        addRow("En_gine", engine, engine);
        addRow("Sho_w", shown, shown);
        addRow("Stop at no_ise", finishing.noise(), finishing.noise());
        addRow("De_noise", finishing.denoiser(), finishing.denoiser());
        addRow("_Format", format, format);
        addRow("_Background", finishing.transparent(), finishing.transparent());
        addRow("_Light layers", finishing.lightLayers(), finishing.lightLayers());
        estimate.setId("render-estimate");
        estimate.getStyleClass().add("hint");
        add(estimate, 1, rows);
        film.selectedProperty().subscribe(_ -> showFormats());
        engines.offersProperty().subscribe(_ -> showEngines());
    }

    /** The error message of the form. */
    ReadOnlyObjectProperty<Optional<String>> complaintProperty() {
        return complaint.getReadOnlyProperty();
    }

    /** The chosen file format. */
    RenderFormat format() {
        return format.choice().orElse(RenderFormat.PNG);
    }

    /** Shows what the scene offers; called while the form is visible. */
    void follow() {
        Scene scene = studio.scene();
        Optional<PictureSize> window = studio.pictureProperty()
                .get()
                .map(seen ->
                        new PictureSize(seen.request().width(), seen.request().height()));
        size.offer(window);
        if (document.isEmpty()) {
            size.show(
                    new PictureSize(scene.rendering().width(), scene.rendering().height()));
            samples.show(RefinementGoal.samples(scene, StageOrView.BEAUTY));
            shown.offer(StagesAndViews.all(), Optional.of(studio.shownProperty().get()));
            films.showUsual();
            engines.want();
        }
        if (!document.equals(Optional.of(studio.document().number()))) {
            document = Optional.of(studio.document().number());
            shadows.show(scene.rendering().shadowSamples());
            films.startAnew();
        }
        films.follow(scene, studio.bodies().meshes());
        finishing.look();
    }

    /** Shows how much the present order is. */
    void showEstimate() {
        estimate.setText(
                complaint.get().isPresent()
                        ? ""
                        : order(Path.of(format().fileName("picture")))
                                .map(order -> RenderEstimate.text(
                                        order, studio.pictureProperty().get()))
                                .orElse(""));
    }

    /** The order of the form for the present scene; empty if there is an error. */
    Optional<RenderOrder> order(Path file) {
        Scene scene = VisibleBodies.of(studio.scene());
        return size.size()
                .filter(_ -> wrongNumber().isEmpty())
                .map(wanted -> scene.withRendering(settings(scene.rendering(), wanted)))
                .flatMap(sized -> engine.choice()
                        .flatMap(chosen -> shown.choice().flatMap(picture -> order(sized, picture, chosen, file))));
    }

    private Optional<RenderOrder> order(Scene scene, StageOrView picture, EngineOffer chosen, Path file) {
        Optional<RenderOrder> order = film.isSelected()
                ? films.film().map(plan -> WindowOrder.film(scene, picture, chosen, plan, file))
                : Optional.of(WindowOrder.picture(moving(scene), picture, chosen, movedBodies(scene), file));
        return order.map(plain -> finishing.applyTo(plain, format()));
    }

    private MovingScene moving(Scene scene) {
        return new MovingScene(later -> studio.film().played(scene, later), films.framesPerSecond());
    }

    private Rendering settings(Rendering usual, PictureSize wanted) {
        return usual.withSize(wanted.width(), wanted.height())
                .withSamplesPerPixel(samples.wholeNumber())
                .withShadowSamples(shadows.wholeNumber());
    }

    /** The picture with the bodies' present places, if they move. */
    private Optional<FrameInput> movedBodies(Scene scene) {
        return studio.pictureProperty()
                .get()
                .filter(_ -> studio.motion().isOn())
                .filter(seen -> seen.request().motion().start()
                                == studio.motion().motionProperty().get().start()
                        && seen.request().scene().spheres().equals(scene.spheres())
                        && seen.request().scene().pour().equals(scene.pour()))
                .map(DrawnPicture::input);
    }

    private void showEngines() {
        List<EngineOffer> working = engines.offersProperty().get().stream()
                .filter(EngineOffer::works)
                .toList();
        String wanted = engine.choice()
                .map(EngineOffer::id)
                .orElse(studio.engineProperty().get().offer().id());
        engine.offer(working, find(working, wanted).or(() -> find(working, FastestEngine.AUTO)));
        check();
    }

    private static Optional<EngineOffer> find(List<EngineOffer> offers, String id) {
        return offers.stream().filter(offer -> offer.id().equals(id)).findFirst();
    }

    private static String name(EngineOffer offer) {
        return offer.device().isEmpty() ? offer.id() : offer.id() + " (" + offer.device() + ")";
    }

    private void showFormats() {
        List<RenderFormat> formats = RenderFormat.of(film.isSelected(), mp4);
        format.offer(formats, Optional.of(formats.getFirst()));
        check();
    }

    private Optional<String> wrongNumber() {
        return samples.complaint()
                .or(shadows::complaint)
                .or(() -> finishing.complaint(
                        samples.wholeNumber(),
                        shown.choice().filter(StageOrView::isColor).isPresent()));
    }

    private void check() {
        finishing.follow(format());
        Optional<String> wrong = (film.isSelected() ? films.complaint() : Optional.<String>empty())
                .or(size::complaint)
                .or(this::wrongNumber);
        complaint.set(
                wrong.or(() -> order(Path.of(format().fileName("picture"))).flatMap(RenderForm::shortage)));
    }

    private static Optional<String> shortage(RenderOrder order) {
        return PictureMemory.of(order.size(), Renderer.bytesPerPixel(order)).map(shortage -> "Size " + shortage.text());
    }

    private void showForFilms(List<Node> row) {
        row.forEach(node -> {
            node.visibleProperty().bind(film.selectedProperty());
            node.managedProperty().bind(film.selectedProperty());
        });
    }

    private List<Node> addRow(String name, Region controls, Node first) {
        Label label = new Label(name);
        label.setMnemonicParsing(true);
        label.setLabelFor(first);
        label.getStyleClass().add("row-name");
        addRow(rows, label, controls);
        rows++;
        first.setAccessibleText(name.replace("_", ""));
        return List.of(label, controls);
    }

    private static RadioButton radio(String id, String label) {
        RadioButton button = new RadioButton(label);
        button.setId(id);
        // The mnemonic of its label does nothing else.
        button.setOnAction(_ -> button.setSelected(true));
        return button;
    }

    /** How much a rendering is, and how long it will take by the time of the window's picture. */
    private static final class RenderEstimate {
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
}
