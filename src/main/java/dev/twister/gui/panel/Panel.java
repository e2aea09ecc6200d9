package dev.twister.gui.panel;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.CommandActions;
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
import dev.twister.world.StageOrView;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.css.PseudoClass;
import javafx.event.ActionEvent;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** The panel at the side, with all settings in sections. */
public final class Panel extends ScrollPane {
    private static final PseudoClass WIDE = PseudoClass.getPseudoClass("wide");

    /** Width of the window from which the panel is wider, in heights of the text. */
    private static final double WIDE_EM = 130;

    private final List<PanelSection> sections;
    private final PanelSection pictureSection;
    private final HistogramView histogram;
    private final SkySection sky;
    private final SelectionSection selection;

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
        histogram = new HistogramView(studio, actions);
        sky = new SkySection(studio, assets);
        selection = new SelectionSection(studio, tags);
        MaterialSection material = new MaterialSection(studio, assets);
        Button reset = actions.button("reset-everything", Command.RESET);
        pictureSection = DrawingSections.picture(studio, tasks, clippingShown, histogram);
        PanelSection lightSection = new PanelSection("Light", new LightSection(studio).rows());
        PanelSection selectionSection = new PanelSection("Selection", selection.bodies(), selection);
        PanelSection materialSection = new PanelSection("Material", material);
        materialSection.visibleProperty().bind(material.visibleProperty());
        materialSection.managedProperty().bind(material.visibleProperty());
        sections = List.of(
                DrawingSections.drawing(
                        studio, engines, studio.engineProperty().get().offer().id()),
                pictureSection,
                selectionSection,
                materialSection,
                SceneSections.camera(studio),
                new PanelSection("Views", new ViewList(studio)),
                lightSection,
                new PanelSection("Sky", sky.rows()),
                SceneSections.plane(studio),
                SceneSections.physics(studio, actions),
                DrawingSections.compare(studio, engines, comparison));
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
        return sections.stream().flatMap(PanelSection::rows).toList();
    }

    private Stream<NumberRow> numbers() {
        return rows().stream().filter(NumberRow.class::isInstance).map(NumberRow.class::cast);
    }

    /** Enters typed numbers; returns false and tells why if one is not allowed. */
    public boolean takeTyped() {
        return numbers().filter(NumberRow::isBeingTyped).allMatch(NumberRow::takeTyped);
    }

    /**
     * Lets Enter lead back to the picture, after a number is entered or a slider moved.
     *
     * @param toPicture gives the picture the focus
     */
    public void leadBack(Runnable toPicture) {
        addEventHandler(ActionEvent.ACTION, event -> {
            if (event.getTarget() instanceof TextField field && isTaken(field)) {
                toPicture.run();
            }
        });
        addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ENTER && event.getTarget() instanceof Slider) {
                toPicture.run();
                event.consume();
            }
        });
    }

    private boolean isTaken(TextField field) {
        return numbers().filter(row -> field.getParent() == row).noneMatch(NumberRow::isBeingTyped);
    }

    /**
     * Lets the keys of rows lead to them, before a window's controls get them.
     *
     * @param show shows the panel
     */
    public void followKeys(Scene scene, Runnable show) {
        scene.addEventFilter(
                KeyEvent.KEY_PRESSED,
                event -> rows().stream()
                        .filter(row -> row.keys().match(event))
                        .findFirst()
                        .ifPresent(row -> {
                            show.run();
                            reveal(row);
                            event.consume();
                        }));
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

    /** Scrolls to a row and gives it the focus. */
    private void reveal(PanelRow row) {
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
        studio.editOnce(
                "everything",
                scene -> studio.document()
                        .original()
                        .withCamera(CameraRig.of(studio.document().original().camera())
                                .on(scene.camera())));
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
}
