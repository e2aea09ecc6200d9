package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.bodies.AxisHandles;
import dev.twister.gui.bodies.BodyMouse;
import dev.twister.gui.bodies.HandleMouse;
import dev.twister.gui.bodies.SelectionView;
import dev.twister.gui.bodies.TransformHandles;
import dev.twister.gui.controls.Command;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.BodyEdits;
import dev.twister.gui.edit.BodyNumber;
import dev.twister.gui.edit.BodyTransform;
import dev.twister.gui.edit.SelectedBodies;
import dev.twister.gui.picking.BodyOutline;
import dev.twister.gui.picture.PathPick;
import dev.twister.gui.picture.PictureView;
import dev.twister.gui.property.PropertyNumbers;
import dev.twister.gui.studio.OpenedScene;
import dev.twister.kernel.Layout;
import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import java.nio.file.Path;
import java.util.List;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.scene.shape.Line;
import javafx.scene.shape.Polygon;
import javafx.scene.shape.Polyline;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Bodies selected, moved, inserted and deleted by hand. */
class BodiesTest {
    private static final int MIDDLE = Layout.FIRST_SPHERE + 1;

    /** Of the outline's corners, x and y each, one that lies under no handle: an eighth of the way around. */
    private static final int UNCOVERED = 2 * 12;

    private static WindowDriver driver;

    @BeforeAll
    static void open() {
        driver = WindowDriver.open();
        driver.run(() -> {
            driver.stage.setWidth(640);
            driver.stage.setHeight(480);
        });
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    @BeforeEach
    void startAnew() {
        driver.type(Command.RESET.keys());
        driver.run(() -> {
            driver.studio.refiningProperty().set(false);
            driver.studio.selection().select(Layout.NOTHING);
        });
        awaitRest();
    }

    /** Layout follows a picture by a pulse. */
    private static DrawnPicture awaitRest() {
        DrawnPicture picture = driver.awaitCurrentPicture();
        driver.pulse();
        driver.pulse();
        return picture;
    }

    private static Scene scene() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static int selected() {
        return WindowDriver.call(driver.studio.selection()::active);
    }

    /** Where on the screen a body's middle is seen. */
    private static Point2D seenAt(int body) {
        return seenAt(body, view());
    }

    private static PictureView view() {
        return driver.find(".picture", PictureView.class);
    }

    private static Point2D seenAt(int body, PictureView view) {
        return WindowDriver.call(() -> {
            DrawnPicture picture = driver.studio.pictureProperty().get().orElseThrow();
            double[] corners = BodyOutline.ofSphere(picture.input(), body, 4);
            double x = (corners[0] + corners[2] + corners[4] + corners[6]) / 4;
            double y = (corners[1] + corners[3] + corners[5] + corners[7]) / 4;
            return view.localToScreen(view.place().toView(x, y));
        });
    }

    private static void click(Point2D place) {
        driver.click(place.getX(), place.getY());
    }

    private static void drag(Point2D from, double right, double down) {
        driver.withRobot(hand -> hand.mouseMove(from.getX(), from.getY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        for (int step = 1; step <= 4; step++) {
            double part = step / 4.0;
            driver.withRobot(hand -> hand.mouseMove(from.getX() + part * right, from.getY() + part * down));
        }
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
    }

    private static void dragTo(Point2D from, Point2D to) {
        drag(from, to.getX() - from.getX(), to.getY() - from.getY());
    }

    @Test
    void aClickSelectsAndTheOutlineLiesOnTheSphere() {
        click(seenAt(MIDDLE));
        assertThat(selected()).isEqualTo(MIDDLE);
        Polygon outline = driver.find("#outline", Polygon.class);
        Bounds place = WindowDriver.call(() -> outline.localToScreen(outline.getLayoutBounds()));
        assertThat(place.contains(seenAt(MIDDLE))).isTrue();
        // The pixels on both sides of the line differ: the sphere ends there.
        Point2D left = new Point2D(place.getMinX() + 6, place.getCenterY());
        click(left);
        assertThat(selected()).isEqualTo(MIDDLE);
        click(new Point2D(place.getMinX() - 4, place.getCenterY()));
        assertThat(selected()).isNotEqualTo(MIDDLE);
    }

    @Test
    void theOutlineIsDrawn() {
        click(seenAt(MIDDLE));
        driver.pulse();
        Polygon outline = driver.find("#outline", Polygon.class);
        Point2D corner = WindowDriver.call(() -> outline.localToScreen(
                outline.getPoints().get(UNCOVERED), outline.getPoints().get(UNCOVERED + 1)));
        // A picture that is painted meanwhile may come before it.
        driver.await(() -> isOutlined(corner));
    }

    private boolean isOutlined(Point2D place) {
        boolean outlined = false;
        // A line between pixels is spread over several.
        for (int x = -1; x <= 1; x++) {
            for (int y = -1; y <= 1; y++) {
                Color seen = driver.pixel(Math.floor(place.getX()) + x, Math.floor(place.getY()) + y);
                outlined |= seen.getRed() > 0.7 && seen.getBlue() < 0.6;
            }
        }
        return outlined;
    }

    @Test
    void aClickOnThePlaneSelectsItWithoutAnOutlineAndOnTheSkyNothing() {
        Bounds picture = driver.pictureOnScreen();
        click(new Point2D(picture.getCenterX(), picture.getMaxY() - 5));
        assertThat(selected()).isEqualTo(Layout.PLANE);
        driver.pulse();
        assertThat(driver.find("#outline", Polygon.class).getPoints()).isEmpty();
        driver.type(KeyCode.DELETE);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
        click(seenAt(MIDDLE));
        click(new Point2D(picture.getCenterX() + 60, picture.getMinY() + 5));
        assertThat(selected()).isEqualTo(Layout.NOTHING);
        assertThat(driver.find("#outline", Polygon.class).getPoints()).isEmpty();
    }

    @Test
    void theSelectedSphereIsMovedAndThatIsOneEdit() {
        Point2D start = seenAt(MIDDLE);
        click(start);
        Vector3 before = BodyEdits.position(scene(), MIDDLE);
        drag(start, 60, -30);
        Vector3 after = BodyEdits.position(scene(), MIDDLE);
        assertThat(after.x()).isGreaterThan(before.x() + 0.2);
        assertThat(after.y()).isGreaterThan(before.y() + 0.1);
        awaitRest();
        Point2D end = seenAt(MIDDLE);
        assertThat(end.getX() - start.getX()).isCloseTo(60, within(6.0));
        assertThat(end.getY() - start.getY()).isCloseTo(-30, within(6.0));
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void whileItIsHeldABodyMovesAlongAnAxisAndSnaps() {
        Point2D start = seenAt(MIDDLE);
        click(start);
        Vector3 before = BodyEdits.position(scene(), MIDDLE);
        driver.withRobot(hand -> hand.mouseMove(start.getX(), start.getY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        driver.withRobot(hand -> hand.mouseMove(start.getX() + 60, start.getY() - 30));
        assertThat(BodyEdits.position(scene(), MIDDLE).y()).isGreaterThan(before.y() + 0.1);
        driver.type(KeyCode.X);
        Vector3 along = BodyEdits.position(scene(), MIDDLE);
        assertThat(along.x()).isGreaterThan(before.x() + 0.2);
        assertThat(along.y()).isEqualTo(before.y());
        assertThat(along.z()).isEqualTo(before.z());
        assertThat(WindowDriver.call(driver.find("#axis", Line.class)::isVisible))
                .isTrue();
        driver.press(KeyCode.CONTROL);
        Vector3 snapped = BodyEdits.position(scene(), MIDDLE);
        assertThat(2 * snapped.x()).isEqualTo(Math.rint(2 * along.x()));
        assertThat(snapped.y()).isEqualTo(before.y());
        driver.release(KeyCode.CONTROL);
        assertThat(BodyEdits.position(scene(), MIDDLE).x()).isCloseTo(along.x(), within(0.05));
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        assertThat(WindowDriver.call(driver.find("#axis", Line.class)::isVisible))
                .isFalse();
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void aDragWhoseEndIsNotReportedEndsWithTheNext() {
        Point2D start = seenAt(MIDDLE);
        click(start);
        fire(MouseEvent.MOUSE_PRESSED, start, view());
        fire(MouseEvent.MOUSE_DRAGGED, start.add(20, 0), view());
        Scene moved = scene();
        Bounds picture = driver.pictureOnScreen();
        Point2D plane = new Point2D(picture.getCenterX() + 60, picture.getMinY() + 130);
        fire(MouseEvent.MOUSE_PRESSED, plane, view());
        fire(MouseEvent.MOUSE_DRAGGED, plane.add(50, 0), view());
        fire(MouseEvent.MOUSE_RELEASED, plane.add(50, 0), view());
        assertThat(moved).isNotEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(scene().spheres()).isEqualTo(moved.spheres());
    }

    /** Beside the window of the other tests, which look at its pixels. */
    private static void show(Stage other, Parent root) {
        other.setScene(new javafx.scene.Scene(root, 320, 240));
        other.setX(driver.stage.getWidth());
        other.setY(0);
        other.show();
    }

    @Test
    void aDragEndsWhenTheWindowLosesTheFocus() {
        driver.run(() -> driver.studio.selection().select(MIDDLE));
        SimpleBooleanProperty focused = new SimpleBooleanProperty(true);
        Stage other = WindowDriver.call(Stage::new);
        PictureView view = WindowDriver.call(() -> new PictureView(driver.studio));
        driver.run(() -> {
            PathPick paths = new PathPick(driver.studio);
            BodyMouse.install(view, driver.studio, paths, new AxisHandles(view, driver.studio, paths), focused);
            show(other, view);
        });
        driver.pulse();
        Point2D start = seenAt(MIDDLE, view);
        fire(MouseEvent.MOUSE_PRESSED, start, view);
        fire(MouseEvent.MOUSE_DRAGGED, start.add(20, 0), view);
        Scene moved = scene();
        driver.run(() -> focused.set(false));
        fire(MouseEvent.MOUSE_DRAGGED, start.add(70, 0), view);
        driver.run(other::hide);
        assertThat(moved).isNotEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(scene()).isEqualTo(moved);
    }

    @Test
    void aDragMovesNoOtherSphereThatIsSelectedMeanwhile() {
        Point2D start = seenAt(MIDDLE);
        click(start);
        fire(MouseEvent.MOUSE_PRESSED, start, view());
        fire(MouseEvent.MOUSE_DRAGGED, start.add(20, 0), view());
        Scene moved = scene();
        driver.type(Command.NEXT.keys());
        fire(MouseEvent.MOUSE_DRAGGED, start.add(50, 0), view());
        fire(MouseEvent.MOUSE_RELEASED, start.add(50, 0), view());
        assertThat(moved).isNotEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(selected()).isEqualTo(MIDDLE + 1);
        assertThat(scene().spheres()).isEqualTo(moved.spheres());
    }

    /** As the system reports it, and no more of it than that. */
    private static void fire(EventType<MouseEvent> type, Point2D place, Node target) {
        fire(type, place, target, false, false);
    }

    private static void fire(EventType<MouseEvent> type, Point2D place, Node target, boolean shift, boolean control) {
        driver.run(() -> {
            Point2D inScene = target.localToScene(target.screenToLocal(place));
            MouseEvent event = new MouseEvent(
                    type,
                    inScene.getX(),
                    inScene.getY(),
                    place.getX(),
                    place.getY(),
                    MouseButton.PRIMARY,
                    1,
                    shift,
                    control,
                    false,
                    false,
                    true,
                    false,
                    false,
                    false,
                    false,
                    type.equals(MouseEvent.MOUSE_CLICKED),
                    null);
            Event.fireEvent(target, event);
        });
    }

    @Test
    void aDragThatBeginsElsewhereLooksAround() {
        click(seenAt(MIDDLE));
        double yaw = scene().camera().yawDegrees();
        drag(seenAt(Layout.FIRST_SPHERE), 50, 0);
        assertThat(scene().camera().yawDegrees()).isNotEqualTo(yaw);
        assertThat(scene().spheres())
                .isEqualTo(WindowDriver.call(driver.studio.document()::original).spheres());
        assertThat(selected()).isEqualTo(MIDDLE);
    }

    @Test
    void aClickInAPictureOfBeforeAnEditSelectsWhatIsSeen() {
        Point2D first = seenAt(Layout.FIRST_SPHERE);
        Point2D middle = seenAt(MIDDLE);
        Polygon outline = driver.find("#outline", Polygon.class);
        driver.run(() -> {
            // The picture is the old one as long as this thread is busy here.
            driver.studio.edit("delete sphere", scene -> BodyEdits.deleted(scene, Layout.FIRST_SPHERE));
            fire(MouseEvent.MOUSE_CLICKED, middle, view());
            assertThat(selected()).isEqualTo(MIDDLE - 1);
            assertThat(outline.localToScreen(outline.getLayoutBounds()).contains(middle))
                    .isTrue();
            fire(MouseEvent.MOUSE_CLICKED, first, view());
            assertThat(selected()).isEqualTo(Layout.NOTHING);
        });
    }

    @Test
    void aClickInAPictureOfBeforeASphereWasReplacedSelectsWhatIsSeen() {
        Point2D first = seenAt(Layout.FIRST_SPHERE);
        Point2D middle = seenAt(MIDDLE);
        driver.run(() -> {
            driver.studio.edit("delete sphere", scene -> BodyEdits.deleted(scene, Layout.FIRST_SPHERE));
            Sphere elsewhere = Sphere.of(new Vector3(0, 20, 0), 1, new Rgb(1, 1, 1), 0);
            driver.studio.edit(
                    "insert sphere", scene -> scene.withBodies(scene.bodies().with(List.of(elsewhere))));
            fire(MouseEvent.MOUSE_CLICKED, middle, view());
            assertThat(selected()).isEqualTo(MIDDLE - 1);
            fire(MouseEvent.MOUSE_CLICKED, first, view());
            assertThat(selected()).isEqualTo(Layout.NOTHING);
        });
        awaitRest();
    }

    @Test
    void aPictureOfTheSceneBeforeSelectsAndOutlinesNothing() {
        Point2D middle = seenAt(MIDDLE);
        Polygon outline = driver.find("#outline", Polygon.class);
        driver.run(() -> {
            driver.studio.show(new OpenedScene(
                    Path.of("test.json"), driver.studio.document().original()));
            fire(MouseEvent.MOUSE_CLICKED, middle, view());
            assertThat(selected()).isEqualTo(Layout.NOTHING);
            driver.studio.selection().select(MIDDLE);
            assertThat(outline.getPoints()).isEmpty();
        });
        driver.await(() -> !outline.getPoints().isEmpty());
    }

    @Test
    void insertAndDeleteCanBeUndone() {
        int before = scene().spheres().size();
        driver.type(KeyCode.INSERT);
        assertThat(scene().spheres()).hasSize(before + 1);
        assertThat(selected()).isEqualTo(Layout.FIRST_SPHERE + before);
        DrawnPicture picture = awaitRest();
        assertThat(picture.input().bodyCount()).isEqualTo(Layout.FIRST_SPHERE + before + 1);
        driver.type(KeyCode.DELETE);
        assertThat(scene().spheres()).hasSize(before);
        assertThat(selected()).isEqualTo(Layout.NOTHING);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().spheres()).hasSize(before + 1);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().spheres()).hasSize(before);
    }

    @Test
    void deleteWithoutASelectionDeletesNothing() {
        driver.type(KeyCode.DELETE);
        driver.run(() -> driver.studio.selection().select(BodyNumber.LIGHT));
        driver.type(KeyCode.DELETE);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void lightsAreInsertedEditedAndDeleted() {
        driver.typeWith(KeyCode.INSERT, KeyCode.CONTROL);
        int second = BodyNumber.ofLight(1);
        assertThat(scene().lights().count()).isEqualTo(2);
        assertThat(selected()).isEqualTo(second);
        DrawnPicture picture = awaitRest();
        assertThat(picture.input().lights()).isEqualTo(2);
        Vector3 place = scene().lights().get(1).position().plus(new Vector3(0, 0.5, 0));
        driver.run(() -> driver.studio.edit("move light", scene -> BodyEdits.moved(scene, second, place)));
        awaitRest();
        driver.run(() -> driver.studio.selection().select(BodyNumber.NONE));
        click(seenAt(Layout.FIRST_SPHERE + scene().spheres().size()));
        assertThat(selected()).isEqualTo(second);
        driver.type(KeyCode.DELETE);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(selected()).isEqualTo(BodyNumber.NONE);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().lights().get(1).position()).isEqualTo(place);
    }

    /** A sun has rows of its own, and is turned, but not moved. */
    @Test
    void sunsAreInsertedAndAimed() {
        driver.typeWith(KeyCode.INSERT, KeyCode.ALT);
        int sun = BodyNumber.ofLight(1);
        assertThat(selected()).isEqualTo(sun);
        assertThat(scene().lights().get(1).isSun()).isTrue();
        awaitRest();
        assertThat(driver.find("#sun-size", Node.class).isVisible()).isTrue();
        assertThat(driver.find("#light-size", Node.class).isVisible()).isFalse();
        BodyTransform turn =
                BodyTransform.of(scene(), SelectedBodies.of(List.of(sun))).orElseThrow();
        driver.run(() -> driver.studio.edit("aim", scene -> turn.rotated(scene, new Vector3(0, 1, 0), 180)));
        assertThat(scene().lights().get(1).shape().direction()).isEqualTo(new Vector3(0.5, -1, -0.5));
        driver.run(() -> driver.studio.selection().select(BodyNumber.LIGHT));
        awaitRest();
        assertThat(driver.find("#light-size", Node.class).isVisible()).isTrue();
    }

    /** A spot has rows of its own, and shines at what its dot is dragged to. */
    @Test
    void spotsAreInsertedAndAimedByTheirDot() {
        driver.type(Command.INSERT_SPOT.keys());
        int spot = BodyNumber.ofLight(1);
        assertThat(selected()).isEqualTo(spot);
        assertThat(scene().lights().get(1).shape().kind()).isEqualTo(LightShape.Kind.SPOT);
        awaitRest();
        assertThat(driver.find("#spot-angle", Node.class).isVisible()).isTrue();
        assertThat(WindowDriver.call(driver.find("#ring-z", Group.class)::isVisible))
                .isTrue();
        Vector3 down = scene().lights().get(1).shape().direction();

        dragTo(middleOf("#aim-handle"), seenAt(Layout.FIRST_SPHERE));

        Light aimed = scene().lights().get(1);
        Vector3 middle = BodyEdits.position(scene(), Layout.FIRST_SPHERE);
        double radius = BodyEdits.sphere(scene(), Layout.FIRST_SPHERE).radius();
        Vector3 away = middle.minus(aimed.position());
        double past = away.cross(aimed.shape().direction()).length();
        assertThat(past).as("meters from the middle").isLessThan(radius);
        assertThat(away.dot(aimed.shape().direction())).isPositive();
        assertThat(away.cross(down).length()).as("before").isGreaterThan(radius);
        awaitRest();
        driver.run(() -> driver.studio.selection().select(BodyNumber.NONE));
        click(seenAt(Layout.FIRST_SPHERE + scene().spheres().size()));
        assertThat(selected()).as("a spot that is not seen").isEqualTo(spot);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().lights().get(1).shape().direction()).isEqualTo(down);
        driver.type(KeyCode.DELETE);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    /** The dot of a sun leads to the ground, and into the sky. */
    @Test
    void sunsAreAimedByTheirDot() {
        driver.type(Command.INSERT_SUN.keys());
        awaitRest();
        Bounds picture = driver.pictureOnScreen();
        dragTo(middleOf("#aim-handle"), new Point2D(picture.getMinX() + 30, picture.getMaxY() - 10));
        Vector3 left = scene().lights().get(1).shape().direction();
        awaitRest();
        dragTo(middleOf("#aim-handle"), new Point2D(picture.getMaxX() - 30, picture.getMaxY() - 10));
        Vector3 right = scene().lights().get(1).shape().direction();
        awaitRest();
        dragTo(middleOf("#aim-handle"), new Point2D(picture.getCenterX(), picture.getMinY() + 5));
        Vector3 up = scene().lights().get(1).shape().direction();

        assertThat(left.x()).isLessThan(right.x());
        assertThat(left.y()).isNegative();
        assertThat(right.y()).isNegative();
        assertThat(up.y()).isPositive();
        assertThat(up.length()).isCloseTo(1, within(1e-5));
    }

    @Test
    void theLightIsMovedToo() {
        driver.run(() -> driver.studio.edit(
                "light", scene -> BodyEdits.moved(scene, BodyNumber.LIGHT, new Vector3(-1.2, 3, 0))));
        awaitRest();
        click(seenAt(Layout.LIGHT));
        assertThat(selected()).isEqualTo(BodyNumber.LIGHT);
        drag(seenAt(Layout.LIGHT), 40, 0);
        assertThat(scene().lights().first().position().x()).isGreaterThan(-1.1);
    }

    @Test
    void escapeSelectsNothing() {
        click(seenAt(MIDDLE));
        driver.type(KeyCode.ESCAPE);
        assertThat(selected()).isEqualTo(Layout.NOTHING);
    }

    @Test
    void aShiftClickWithControlFocusesOnWhatIsUnderThePointerAndThatIsOneEdit() {
        Scene before = scene();
        int selected = selected();
        Point2D place = seenAt(MIDDLE);
        // The robot's clicks say of no key that is held.
        fire(MouseEvent.MOUSE_CLICKED, place, view(), true, true);

        Vector3 center = BodyEdits.position(before, MIDDLE);
        double radius = BodyEdits.sphere(before, MIDDLE).radius();
        double away = Math.hypot(
                Math.hypot(
                        center.x() - before.camera().position().x(),
                        center.y() - before.camera().position().y()),
                center.z() - before.camera().position().z());
        double focus = scene().camera().focusDistance();
        assertThat(focus).isBetween(away - 3 * radius, away);
        assertThat(selected()).isEqualTo(selected);
        assertThat(driver.notice()).startsWith("Focus distance: ");
        driver.run(() -> driver.studio.edit(
                "aperture", now -> now.withCamera(now.camera().withAperture(0.1))));
        driver.awaitCurrentPicture();
        driver.await(() -> driver.text("facts")
                .endsWith("focus at " + PropertyNumbers.FOCUS_DISTANCE.scale().text(focus) + " m"));
        driver.run(driver.studio::undo);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(before);
    }

    private static SelectedBodies bodies() {
        return WindowDriver.call(driver.studio.selection()::bodies);
    }

    private static void shiftClick(Point2D place) {
        fire(MouseEvent.MOUSE_CLICKED, place, view(), true, false);
    }

    private static void selectTwo() {
        click(seenAt(Layout.FIRST_SPHERE));
        shiftClick(seenAt(MIDDLE));
        driver.pulse();
    }

    @Test
    void shiftClicksAddBodiesAndTakeThemOut() {
        selectTwo();
        assertThat(bodies().bodies()).containsExactly(Layout.FIRST_SPHERE, MIDDLE);
        assertThat(selected()).isEqualTo(MIDDLE);
        shiftClick(seenAt(MIDDLE));
        assertThat(bodies()).isEqualTo(SelectedBodies.of(Layout.FIRST_SPHERE));
    }

    @Test
    void aClickWithControlAddsABodyToo() {
        click(seenAt(Layout.FIRST_SPHERE));
        fire(MouseEvent.MOUSE_CLICKED, seenAt(MIDDLE), view(), false, true);
        assertThat(bodies().bodies()).containsExactly(Layout.FIRST_SPHERE, MIDDLE);
    }

    @Test
    void theOtherSelectedBodiesAreOutlinedApart() {
        selectTwo();
        Group others = driver.find("#other-outlines", Group.class);
        assertThat(WindowDriver.call(() -> others.getChildren().size())).isEqualTo(1);
        Bounds place = WindowDriver.call(() -> others.localToScreen(others.getLayoutBounds()));
        assertThat(place.contains(seenAt(Layout.FIRST_SPHERE))).isTrue();
        click(seenAt(MIDDLE));
        assertThat(WindowDriver.call(() -> others.getChildren().size())).isZero();
    }

    @Test
    void thePlaneIsOnlySelectedAlone() {
        click(seenAt(MIDDLE));
        Bounds picture = driver.pictureOnScreen();
        shiftClick(new Point2D(picture.getCenterX(), picture.getMaxY() - 5));
        assertThat(bodies()).isEqualTo(SelectedBodies.of(MIDDLE));
        assertThat(driver.notice()).isEqualTo("The plane is only selected alone");
    }

    @Test
    void allSelectedBodiesAreMovedByOneOfThemAndThatIsOneEdit() {
        Vector3 first = BodyEdits.position(scene(), Layout.FIRST_SPHERE);
        Vector3 middle = BodyEdits.position(scene(), MIDDLE);
        selectTwo();
        drag(seenAt(Layout.FIRST_SPHERE), 30, -20);
        Vector3 moved = BodyEdits.position(scene(), Layout.FIRST_SPHERE);
        Vector3 along = BodyEdits.position(scene(), MIDDLE);
        assertThat(selected()).isEqualTo(Layout.FIRST_SPHERE);
        assertThat(moved.x()).isGreaterThan(first.x() + 0.1);
        assertThat(along.x() - middle.x()).isCloseTo(moved.x() - first.x(), within(1e-9));
        assertThat(along.y() - middle.y()).isCloseTo(moved.y() - first.y(), within(1e-9));
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(bodies().count()).isEqualTo(2);
    }

    @Test
    void allMovableBodiesAreSelectedAndTheLightIsNotDeletedWithThem() {
        driver.type(Command.SELECT_ALL.keys());
        assertThat(bodies().count()).isEqualTo(1 + scene().spheres().size());
        driver.type(KeyCode.DELETE);
        assertThat(scene().spheres()).isEmpty();
        assertThat(bodies()).isEqualTo(SelectedBodies.of(BodyNumber.LIGHT));
        assertThat(driver.notice()).isEqualTo("The last light can't be deleted; a scene has at least one");
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void aLightIsDuplicatedBesideASphere() {
        driver.run(() -> driver.studio.selection().select(List.of(BodyNumber.LIGHT, MIDDLE)));
        Scene before = scene();
        driver.type(Command.DUPLICATE.keys());
        Light first = before.lights().first();
        Light copy = scene().lights().get(1);
        assertThat(copy.withPosition(first.position())).isEqualTo(first);
        assertThat(copy.position().x()).isGreaterThan(first.position().x());
        assertThat(scene().spheres()).hasSize(before.spheres().size() + 1);
        assertThat(bodies().bodies())
                .containsExactlyInAnyOrder(
                        BodyNumber.ofLight(1),
                        BodyNumber.ofSphere(before.spheres().size()));
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(before);
    }

    @Test
    void allSelectedBodiesAreDuplicatedCopiedAndPasted() {
        int before = scene().spheres().size();
        selectTwo();
        driver.type(Command.COPY.keys());
        driver.type(Command.DUPLICATE.keys());
        assertThat(scene().spheres()).hasSize(before + 2);
        assertThat(bodies().bodies()).containsExactly(Layout.FIRST_SPHERE + before, Layout.FIRST_SPHERE + before + 1);
        driver.type(Command.PASTE.keys());
        assertThat(scene().spheres()).hasSize(before + 4);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void allSelectedBodiesAreFramed() {
        selectTwo();
        driver.type(Command.FRAME.keys());
        awaitRest();
        Bounds picture = driver.pictureOnScreen();
        assertThat(picture.contains(seenAt(Layout.FIRST_SPHERE))).isTrue();
        assertThat(picture.contains(seenAt(MIDDLE))).isTrue();
    }

    private static Point2D handle(String axis) {
        Group arrow = driver.find("#handle-" + axis, Group.class);
        return WindowDriver.call(() -> {
            Polygon head = (Polygon) arrow.lookup(".handle-head");
            // The tip, then a little towards the middle.
            Point2D tip = new Point2D(head.getPoints().get(2), head.getPoints().get(3));
            Point2D left = new Point2D(head.getPoints().get(0), head.getPoints().get(1));
            Point2D right =
                    new Point2D(head.getPoints().get(4), head.getPoints().get(5));
            return head.localToScreen(left.midpoint(right).interpolate(tip, 0.5));
        });
    }

    private static boolean isHandleSeen(String axis) {
        return WindowDriver.call(driver.find("#handle-" + axis, Group.class)::isVisible);
    }

    @Test
    void aHandleMovesTheSelectedBodiesAlongItsAxis() {
        Vector3 first = BodyEdits.position(scene(), Layout.FIRST_SPHERE);
        Vector3 before = BodyEdits.position(scene(), MIDDLE);
        selectTwo();
        drag(handle("y"), 25, -40);
        Vector3 after = BodyEdits.position(scene(), MIDDLE);
        assertThat(after.y()).isGreaterThan(before.y() + 0.2);
        assertThat(after).isEqualTo(new Vector3(before.x(), after.y(), before.z()));
        assertThat(BodyEdits.position(scene(), Layout.FIRST_SPHERE).y())
                .isCloseTo(first.y() + after.y() - before.y(), within(1e-9));
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void withShiftADraggedBodyRestsOnWhatIsUnderThePointer() {
        click(seenAt(MIDDLE));
        Point2D from = seenAt(MIDDLE);
        Bounds picture = driver.pictureOnScreen();
        driver.withRobot(hand -> hand.mouseMove(from.getX(), from.getY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        driver.withRobot(hand -> hand.mouseMove(from.getX() + 10, picture.getMaxY() - 20));
        driver.press(KeyCode.SHIFT);
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        driver.release(KeyCode.SHIFT);
        double lowest = BodyEdits.position(scene(), MIDDLE).y()
                - BodyEdits.sphere(scene(), MIDDLE).radius();
        assertThat(lowest).isCloseTo(scene().ground().height(), within(1e-3));
    }

    @Test
    void theBoxScalesTheSelectedBodiesInOneStep() {
        double before = BodyEdits.sphere(scene(), MIDDLE).radius();
        click(seenAt(MIDDLE));
        drag(middleOf("#scale-handle"), 30, 30);
        assertThat(BodyEdits.sphere(scene(), MIDDLE).radius()).isGreaterThan(before * 1.2);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void aRingRotatesTheSelectedBodiesAboutTheActiveOne() {
        click(seenAt(MIDDLE));
        assertThat(WindowDriver.call(driver.find("#ring-z", Group.class)::isVisible))
                .as("a sphere alone does not turn")
                .isFalse();
        Vector3 first = BodyEdits.position(scene(), Layout.FIRST_SPHERE);
        Vector3 active = BodyEdits.position(scene(), MIDDLE);
        selectTwo();
        Group ring = driver.find("#ring-z", Group.class);
        Point2D place = WindowDriver.call(() -> {
            Polyline line = (Polyline) ring.lookup(".handle");
            // Beside the arrows.
            int corner = 2 * (line.getPoints().size() / 2 * 3 / 8);
            return line.localToScreen(
                    line.getPoints().get(corner), line.getPoints().get(corner + 1));
        });
        drag(place, 12, 12);
        assertThat(BodyEdits.position(scene(), MIDDLE)).isEqualTo(active);
        Vector3 turned = BodyEdits.position(scene(), Layout.FIRST_SPHERE);
        assertThat(turned).isNotEqualTo(first);
        assertThat(turned.minus(active).length()).isCloseTo(first.minus(active).length(), within(1e-6));
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    private static double radius() {
        return BodyEdits.sphere(scene(), MIDDLE).radius();
    }

    @Test
    void theDividerOverAHandleIsWhatThePointerHolds() {
        click(seenAt(MIDDLE));
        driver.typeWith(KeyCode.K, KeyCode.CONTROL);
        driver.pulse();
        Point2D box = middleOf("#scale-handle");
        Region divider = driver.find("#divider", Region.class);
        // The robot's drags leave what moves with them.
        fire(MouseEvent.MOUSE_DRAGGED, box, divider);
        driver.pulse();
        double before = radius();
        driver.withRobot(hand -> hand.mouseMove(box.getX(), box.getY()));
        assertThat(WindowDriver.call(driver.find("#scale-handle", Node.class)::getPseudoClassStates))
                .extracting(Object::toString)
                .doesNotContain("pointed");
        fire(MouseEvent.MOUSE_PRESSED, box, divider);
        fire(MouseEvent.MOUSE_DRAGGED, box.add(30, 0), divider);
        fire(MouseEvent.MOUSE_RELEASED, box.add(30, 0), divider);
        driver.pulse();
        assertThat(radius()).isEqualTo(before);
        assertThat(middleOf("#divider").getX()).isCloseTo(box.getX() + 30, within(2.0));
        driver.typeWith(KeyCode.K, KeyCode.CONTROL);
    }

    @Test
    void anotherButtonChangesNothingWhileAHandleIsHeld() {
        click(seenAt(MIDDLE));
        Point2D box = middleOf("#scale-handle");
        driver.withRobot(hand -> hand.mouseMove(box.getX(), box.getY()));
        driver.withRobot(hand -> hand.mousePress(MouseButton.PRIMARY));
        driver.withRobot(hand -> hand.mouseMove(box.getX() + 10, box.getY() + 10));
        double before = radius();
        driver.withRobot(hand -> hand.mousePress(MouseButton.SECONDARY));
        driver.withRobot(hand -> hand.mouseMove(box.getX() + 20, box.getY() + 20));
        double pressed = radius();
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.SECONDARY));
        driver.withRobot(hand -> hand.mouseMove(box.getX() + 30, box.getY() + 30));
        driver.withRobot(hand -> hand.mouseRelease(MouseButton.PRIMARY));
        assertThat(pressed).isGreaterThan(before);
        assertThat(radius()).isGreaterThan(pressed);
        assertThat(bodies()).isEqualTo(SelectedBodies.of(MIDDLE));
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene()).isEqualTo(WindowDriver.call(driver.studio.document()::original));
    }

    @Test
    void aHandleIsLetGoWhenTheWindowLosesTheFocus() {
        driver.run(() -> driver.studio.selection().select(MIDDLE));
        SimpleBooleanProperty focused = new SimpleBooleanProperty(true);
        Stage other = WindowDriver.call(Stage::new);
        PictureView view = WindowDriver.call(() -> new PictureView(driver.studio));
        driver.run(() -> {
            StackPane around = new StackPane(view);
            AxisHandles arrows = new AxisHandles(view, driver.studio, new PathPick(driver.studio));
            TransformHandles handles = new TransformHandles(view, driver.studio, arrows);
            HandleMouse.install(around, view, driver.studio, handles, focused);
            view.addOverlay(new SelectionView(view, driver.studio, List.of(handles, arrows)));
            show(other, around);
        });
        driver.pulse();
        driver.await(() -> view.lookup("#scale-handle").isVisible());
        Point2D start = middleOf(view.lookup("#scale-handle"));
        fire(MouseEvent.MOUSE_PRESSED, start, view);
        fire(MouseEvent.MOUSE_DRAGGED, start.add(20, 20), view);
        Scene scaled = scene();
        driver.run(() -> focused.set(false));
        fire(MouseEvent.MOUSE_DRAGGED, start.add(70, 70), view);
        driver.run(other::hide);
        assertThat(scaled).isNotEqualTo(WindowDriver.call(driver.studio.document()::original));
        assertThat(scene()).isEqualTo(scaled);
    }

    private static Point2D middleOf(String selector) {
        return middleOf(driver.find(selector, Node.class));
    }

    private static Point2D middleOf(Node node) {
        return WindowDriver.call(() -> node.localToScreen(
                node.getLayoutBounds().getCenterX(), node.getLayoutBounds().getCenterY()));
    }

    @Test
    void aClickOnAHandleKeepsTheSelection() {
        click(seenAt(MIDDLE));
        click(handle("y"));
        assertThat(bodies()).isEqualTo(SelectedBodies.of(MIDDLE));
    }

    @Test
    void aHandleUnderThePointerIsShownByIt() {
        click(seenAt(MIDDLE));
        Point2D place = handle("x");
        driver.withRobot(hand -> hand.mouseMove(place.getX(), place.getY()));
        Line line = (Line)
                WindowDriver.call(() -> driver.find("#handle-x", Group.class).lookup(".handle"));
        assertThat(line.getPseudoClassStates()).extracting(Object::toString).contains("pointed");
        Point2D elsewhere = seenAt(Layout.FIRST_SPHERE);
        driver.withRobot(hand -> hand.mouseMove(elsewhere.getX(), elsewhere.getY()));
        assertThat(line.getPseudoClassStates()).extracting(Object::toString).doesNotContain("pointed");
    }

    @Test
    void thereAreNoHandlesWhereNothingCanBeMoved() {
        assertThat(isHandleSeen("x")).isFalse();
        driver.run(() -> driver.studio.selection().select(Layout.PLANE));
        assertThat(isHandleSeen("x")).isFalse();
        driver.run(() -> driver.studio.selection().select(MIDDLE));
        assertThat(isHandleSeen("x")).isTrue();
    }
}
