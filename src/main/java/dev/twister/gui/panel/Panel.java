package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
import dev.twister.gui.controls.Tooltips;
import dev.twister.gui.drawing.ResolutionMode;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.CameraRig;
import dev.twister.gui.files.AssetActions;
import dev.twister.gui.files.SettingsKeeper;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.picture.Comparison;
import dev.twister.gui.picture.HistogramView;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.Denoising;
import dev.twister.gui.studio.EngineList;
import dev.twister.gui.studio.Studio;
import dev.twister.gui.studio.TagActions;
import dev.twister.scene.Scene;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.Property;
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.css.PseudoClass;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** The panel at the side, with all settings in sections. */
public final class Panel extends ScrollPane {
    private static final PseudoClass WIDE = PseudoClass.getPseudoClass("wide");

    /** Width of the window from which the panel is wider, in heights of the text. */
    private static final double WIDE_EM = 130;

    private final EngineSection engine;
    private final CompareSection compare;
    private final List<PropertyRow> plane;
    private final List<PanelSection> sections;
    private final PictureSection picture;
    private final PanelSection pictureSection;
    private final HistogramView histogram;
    private final CameraSection camera;
    private final LightSection light;
    private final SkySection sky;
    private final PhysicsSection physics;
    private final SelectionSection selection;
    private final MaterialSection material;

    /** What is to be scrolled to once the panel is shown. */
    private Optional<Region> sought = Optional.empty();

    public Panel(
            Studio studio,
            EngineList engines,
            Comparison comparison,
            BooleanProperty clippingShown,
            AssetActions assets,
            TagActions tags,
            BackgroundTasks tasks,
            CommandActions actions) {
        engine = new EngineSection(
                studio, engines, studio.engineProperty().get().offer().id());
        compare = new CompareSection(studio, engines, comparison);
        picture = new PictureSection(studio, tasks, clippingShown);
        histogram = new HistogramView(studio, actions);
        camera = new CameraSection(studio);
        light = new LightSection(studio);
        sky = new SkySection(studio, assets);
        plane = PropertyRow.following(Property.within(BodyProperties.PLANE, Scene::ground, Scene::withGround), studio);
        physics = new PhysicsSection(studio, actions);
        selection = new SelectionSection(studio, tags);
        material = new MaterialSection(studio, assets);
        Button reset = new Button("Reset everything");
        reset.setId("reset-everything");
        reset.setTooltip(Tooltips.of(
                Command.RESET.hint() + "\nKey: " + Command.RESET.keys().getDisplayText()));
        reset.setOnAction(_ -> actions.run(Command.RESET));
        PanelSection physicsSection = section("Physics", physics.rows());
        physicsSection.add(physics.buttons());
        pictureSection = section("Picture", picture.rows());
        pictureSection.add(histogram);
        PanelSection lightSection = section("Light", light.rows());
        PanelSection planeSection = section("Plane", rows(plane));
        planeSection.add(selectPlane(studio));
        PanelSection selectionSection = new PanelSection("Selection", selection.bodies(), selection);
        PanelSection materialSection = new PanelSection("Material", material);
        materialSection.visibleProperty().bind(material.visibleProperty());
        materialSection.managedProperty().bind(material.visibleProperty());
        sections = List.of(
                section("Drawing", engine.rows()),
                pictureSection,
                selectionSection,
                materialSection,
                section("Camera", camera.rows()),
                new PanelSection("Views", new ViewList(studio)),
                lightSection,
                section("Sky", sky.rows()),
                planeSection,
                physicsSection,
                section("Compare", compare.rows()));
        VBox all = new VBox(sections.toArray(PanelSection[]::new));
        all.getChildren().add(reset);
        all.getStyleClass().add("sections");
        setId("panel");
        sceneProperty()
                .flatMap(window -> window.widthProperty())
                .subscribe(width -> pseudoClassStateChanged(
                        WIDE,
                        width != null
                                && width.doubleValue()
                                        >= WIDE_EM * reset.getFont().getSize()));
        setContent(all);
        setFitToWidth(true);
        setHbarPolicy(ScrollBarPolicy.NEVER);
        setFocusTraversable(false);
        visibleProperty().subscribe(this::scrollToSought);
        studio.selection().activeProperty().subscribe((_, body) -> {
            if (body.intValue() != BodyNumber.NONE) {
                PanelSection ofBody = body.intValue() == BodyNumber.PLANE ? materialSection : selectionSection;
                PanelSection section = BodyEdits.isLight(studio.scene(), body.intValue()) ? lightSection : ofBody;
                section.fold(false);
                scrollTo(section);
            }
        });
    }

    /** All rows in their order. */
    public List<PanelRow> rows() {
        return Stream.of(
                        engine.rows(),
                        picture.rows(),
                        selection.rows(),
                        material.rows(),
                        camera.rows(),
                        light.rows(),
                        sky.rows(),
                        rows(plane),
                        physics.rows(),
                        compare.rows())
                .flatMap(List::stream)
                .toList();
    }

    private static List<PanelRow> rows(List<PropertyRow> rows) {
        return rows.stream().map(PropertyRow::row).toList();
    }

    private static HBox selectPlane(Studio studio) {
        Button select = new Button("Colors and material…");
        select.setId("select-plane");
        select.setTooltip(Tooltips.of("Selects the plane, so that Material shows its colors and reflectivity."));
        select.setOnAction(_ -> studio.selection().select(BodyNumber.PLANE));
        HBox buttons = new HBox(select);
        buttons.getStyleClass().add("buttons");
        return buttons;
    }

    /** Enters typed numbers; returns false and tells why if one is not allowed. */
    public boolean takeTyped() {
        return rows().stream()
                .filter(NumberRow.class::isInstance)
                .map(NumberRow.class::cast)
                .filter(NumberRow::isBeingTyped)
                .allMatch(NumberRow::takeTyped);
    }

    /** Whether the text of a row's field was entered. */
    boolean isTaken(TextField field) {
        return rows().stream()
                .filter(NumberRow.class::isInstance)
                .map(NumberRow.class::cast)
                .filter(row -> field.getParent() == row)
                .noneMatch(NumberRow::isBeingTyped);
    }

    /** Called in every pulse: updates what changes without edits. */
    public void pulse(long nanos) {
        if (isVisible()) {
            selection.pulse(nanos);
            if (!pictureSection.isFolded()) {
                histogram.pulse(nanos);
            }
        }
    }

    /** Adds panoramas to the list of skies. */
    public void offerSkies(List<Path> panoramas) {
        sky.offer(panoramas);
    }

    /** The row that has the key of an event. */
    Optional<PanelRow> rowOf(KeyEvent event) {
        return rows().stream().filter(row -> row.keys().match(event)).findFirst();
    }

    /** Scrolls to a row and gives it the focus. */
    void reveal(PanelRow row) {
        sections.stream().filter(section -> contains(section, row)).forEach(section -> section.fold(false));
        scrollTo(row);
        getScene().getWindow().requestFocus();
        row.firstControl().requestFocus();
    }

    private static boolean contains(Node ancestor, Node node) {
        Node at = node;
        while (at != null && !at.equals(ancestor)) {
            at = at.getParent();
        }
        return at != null;
    }

    /** Restores which sections are folded, and keeps it from now on. */
    public void foldAsKept(SettingsKeeper settings) {
        List<String> folded = settings.settings().get(WindowSettings.FOLDED);
        sections.forEach(section -> section.makeFoldable(
                folded.contains(section.heading()),
                isFolded -> settings.change(kept -> kept.withFolded(section.heading(), isFolded))));
    }

    /** Scrolls a part to the middle of the panel, unless it is visible; a hidden panel does so once it is shown. */
    public void scrollTo(Region part) {
        sought = Optional.of(part);
        scrollToSought();
    }

    private void scrollToSought() {
        if (isVisible()) {
            sought.ifPresent(this::scrollShown);
            sought = Optional.empty();
        }
    }

    private void scrollShown(Region part) {
        applyCss();
        layout();
        Bounds place = getContent().sceneToLocal(part.localToScene(part.getLayoutBounds()));
        double height = getViewportBounds().getHeight();
        double hidden = getContent().getLayoutBounds().getHeight() - height;
        double seenFrom = getVvalue() * hidden;
        boolean seen = place.getMinY() >= seenFrom && place.getMaxY() <= seenFrom + height;
        if (hidden > 0 && !seen) {
            setVvalue(Math.clamp((place.getCenterY() - height / 2) / hidden, 0, 1));
        }
    }

    /** Resets the engine, the resolution, the scene, refinement and denoising. */
    public static void resetAll(Studio studio, BackgroundTasks tasks, EngineList engines, String usualEngine) {
        // First, because an edit of moving bodies keeps their places.
        studio.motion().setOn(false);
        studio.edit(
                "everything",
                scene -> studio.document()
                        .original()
                        .withCamera(CameraRig.of(studio.document().original().camera())
                                .on(scene.camera())));
        studio.endGesture();
        studio.cameraControl().goHome();
        studio.setResolution(ResolutionMode.WINDOW);
        studio.setShown(StageOrView.BEAUTY);
        studio.refiningProperty().set(true);
        studio.noiseGoalProperty().set(0.0);
        if (studio.denoiserProperty().get().isEmpty()) {
            Denoising.start(studio, tasks, _ -> {});
        }
        if (!studio.engineProperty().get().offer().id().equals(usualEngine)) {
            engines.find(usualEngine).ifPresent(studio::chooseEngine);
        }
    }

    private static PanelSection section(String heading, List<PanelRow> rows) {
        return new PanelSection(heading, rows.toArray(PanelRow[]::new));
    }
}
