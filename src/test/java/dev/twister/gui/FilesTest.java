package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.controls.Command;
import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.gui.edit.SceneHistory;
import dev.twister.gui.files.SceneSaving;
import dev.twister.gui.files.WindowSettings;
import dev.twister.gui.panel.Panel;
import dev.twister.gui.picture.PictureActions;
import dev.twister.gui.property.DaylightFile;
import dev.twister.gui.studio.BackgroundTasks;
import dev.twister.gui.studio.EditedFile;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshReader;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.format.SceneReader;
import dev.twister.scene.format.SceneWriter;
import dev.twister.scene.select.SceneBodies;
import dev.twister.scene.select.Title;
import dev.twister.sky.ShippedSky;
import dev.twister.sky.SkyException;
import dev.twister.sky.SkyboxReader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import javafx.scene.control.Button;
import javafx.scene.control.ComboBox;
import javafx.scene.control.DialogPane;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Scenes, skies, screenshots and recordings, and what goes wrong with them. */
class FilesTest {
    private static WindowDriver driver;

    @TempDir
    private Path folder;

    @BeforeAll
    static void open() {
        driver = WindowDriver.open();
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    @BeforeEach
    void startAnew() throws IOException {
        Path scene =
                Files.copy(Path.of("scenes", "teaching.json"), sceneFolder().resolve("start.json"));
        driver.run(() -> {
            driver.studio.show(driver.studio.assets().readScene(scene));
            driver.files.chooseNothing();
            driver.studio.edit(
                    "shadows", now -> now.withRendering(now.rendering().withShadowSamples(1)));
            SceneHistory.Version saved = driver.studio.document().toSave();
            SceneWriter.write(saved.scene(), scene);
            driver.studio.document().saved(saved, new EditedFile(scene, EditedFile.Digest.of(scene)));
        });
        driver.awaitCurrentPicture();
    }

    /** With the skies next to it, as shipped scenes expect. */
    private Path sceneFolder() throws IOException {
        Path skies = Files.createDirectories(folder.resolve("skyboxes"));
        Files.copy(Path.of("skyboxes", "day.hdr"), skies.resolve("day.hdr"));
        return Files.createDirectories(folder.resolve("scenes"));
    }

    private static Scene scene() {
        return WindowDriver.call(driver.studio::scene);
    }

    private static void change() {
        driver.run(() -> {
            driver.studio.edit(
                    "bounces",
                    now -> now.withRendering(
                            now.rendering().withBounces(now.rendering().bounces() + 1)));
            driver.studio.endGesture();
        });
    }

    private static Optional<DialogPane> dialog(String id) {
        return driver.dialog(id);
    }

    private static DialogPane awaitDialog(String id) {
        return driver.awaitDialog(id);
    }

    private static void answer(DialogPane dialog, String button) {
        driver.answer(dialog, button);
    }

    private static void drop(Path file) {
        driver.run(() -> driver.window.workbench().files().drop(List.of(file)));
    }

    /** What can be dropped on a window that is neither a scene nor a sky. */
    enum Hostile {
        MISSING(folder -> folder.resolve("missing.json")),
        MISSING_SKY(folder -> folder.resolve("missing.hdr")),
        A_FOLDER(folder -> Files.createDirectory(folder.resolve("folder.json"))),
        EMPTY(folder -> Files.createFile(folder.resolve("empty.json"))),
        BINARY_SCENE(folder -> Files.write(folder.resolve("binary.json"), new byte[] {0, -1, -2, 0, 7})),
        SCHEMA(folder -> Files.writeString(folder.resolve("x.schema.json"), "{}")),
        BINARY(folder -> Files.write(folder.resolve("program"), new byte[] {127, 'E', 'L', 'F', 0, 1})),
        OTHER_JSON(folder -> Files.writeString(folder.resolve("package.json"), "{\"name\": \"left-pad\"}")),
        HALF_A_SCENE(folder -> Files.writeString(
                folder.resolve("half.json"),
                Files.readString(Path.of("scenes", "teaching.json")).substring(0, 300))),
        HUGE_SCENE(folder -> sized(folder.resolve("huge.json"), 65L << 20)),
        BROKEN_HDR(folder ->
                Files.writeString(folder.resolve("broken.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 9")),
        HUGE_HDR(folder -> Files.writeString(
                folder.resolve("wide.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999 +X 999999\n")),
        BROKEN_MESH(folder -> Files.writeString(folder.resolve("broken.ply"), "ply\nformat ascii 1.0\n")),
        NO_TRIANGLES(folder -> Files.writeString(folder.resolve("empty.obj"), "v 0 0 0\n")),
        NOT_A_PICTURE(folder -> Files.writeString(folder.resolve("text.png"), "hello")),
        HUGE_PICTURE(folder -> sized(folder.resolve("huge.hdr"), 2L << 30));

        private interface Making {
            Path in(Path folder) throws IOException;
        }

        @SuppressWarnings("ImmutableEnumChecker") // writes a file
        private final Making making;

        Hostile(Making making) {
            this.making = making;
        }

        private static Path sized(Path file, long bytes) throws IOException {
            try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
                sparse.setLength(bytes);
            }
            return file;
        }
    }

    /** What the command line says of a file. */
    private static String commandLinesMessage(Path file) {
        try {
            if (file.toString().matches(".*\\.(obj|ply)")) {
                MeshReader.read(file, 0, _ -> {});
            } else if (file.toString().endsWith(".json")) {
                Scene scene = SceneReader.read(file);
                SkyboxReader.read(scene.sky().file());
            } else {
                SkyboxReader.read(file);
            }
            throw new AssertionError(file + " is all right");
        } catch (SceneException | SkyException | MeshException problem) {
            return problem.getMessage();
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"MISSING", "BINARY", "HALF_A_SCENE"})
    void whatCannotBeOpenedIsSaidAndEverythingGoesOn(Hostile hostile) throws IOException {
        requireComplaint(hostile);
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(
            names = {"MISSING", "BINARY", "HALF_A_SCENE"},
            mode = EnumSource.Mode.EXCLUDE)
    void whatElseCannotBeOpenedIsSaidToo(Hostile hostile) throws IOException {
        requireComplaint(hostile);
    }

    private void requireComplaint(Hostile hostile) throws IOException {
        Path file = hostile.making.in(folder.resolve("scenes"));
        Scene before = scene();
        drop(file);
        DialogPane dialog = awaitDialog("complaint");
        switch (hostile) {
            case A_FOLDER ->
                assertThat(dialog.getContentText()).startsWith(file.toString()).contains("is a folder");
            case SCHEMA ->
                assertThat(dialog.getContentText()).startsWith(file.toString()).contains("describes scenes");
            case BINARY ->
                assertThat(dialog.getContentText()).startsWith(file.toString()).contains("unknown kind of file");
            default -> assertThat(dialog.getContentText()).isEqualTo(commandLinesMessage(file));
        }
        assertThat(dialog.getContentText().lines()).hasSize(1);
        assertThat(scene()).isEqualTo(before);
        change();
        driver.awaitCurrentPicture();
        answer(dialog, "OK");
    }

    @Test
    void aSceneIsOpenedSavedAndRemembered() throws IOException {
        Path other = folder.resolve("scenes").resolve("other.json");
        Files.copy(folder.resolve("scenes").resolve("start.json"), other);
        driver.files.choose(other);
        driver.typeWith(KeyCode.O, KeyCode.CONTROL);
        driver.await(() -> driver.studio.document().file().equals(other));
        assertThat(WindowDriver.call(driver.stage::getTitle)).isEqualTo("other.json – Twister");
        change();
        assertThat(WindowDriver.call(driver.stage::getTitle)).isEqualTo("• other.json – Twister");
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        assertThat(SceneReader.read(other)).isEqualTo(scene());
        assertThat(WindowDriver.call(driver.stage::getTitle)).isEqualTo("other.json – Twister");
        Path third = folder.resolve("scenes").resolve("third.json");
        driver.files.choose(third);
        driver.typeWith(KeyCode.S, KeyCode.CONTROL, KeyCode.SHIFT);
        driver.await(() -> driver.studio.document().file().equals(third));
        assertThat(SceneReader.read(third)).isEqualTo(scene());
        assertThat(driver.notice()).isEqualTo("Saved " + third);
        assertThat(driver.window.workbench().settings().settings().get(WindowSettings.RECENT_SCENES))
                .startsWith(third.toString(), other.toString());
    }

    @Test
    void changesAreNotLostUnasked() throws IOException {
        Path other = Files.copy(
                folder.resolve("scenes").resolve("start.json"),
                folder.resolve("scenes").resolve("b.json"));
        Path start = folder.resolve("scenes").resolve("start.json");
        change();
        Scene changed = scene();
        drop(other);
        answer(awaitDialog("save-question"), "Cancel");
        assertThat(scene()).isEqualTo(changed);
        drop(other);
        answer(awaitDialog("save-question"), "Save");
        driver.await(() -> driver.studio.document().file().equals(other));
        assertThat(SceneReader.read(start)).isEqualTo(changed);
        change();
        drop(start);
        answer(awaitDialog("save-question"), "Don't save");
        driver.await(() -> driver.studio.document().file().equals(start));
        assertThat(SceneReader.read(other).rendering().bounces())
                .isEqualTo(changed.rendering().bounces() - 1);
    }

    @Test
    void whatWouldLoseChangesWaitsForASceneThatIsBeingWritten() {
        Path start = folder.resolve("scenes").resolve("start.json");
        change();
        Scene changed = scene();
        CompletableFuture<Scene> left = new CompletableFuture<>();
        SceneSaving saving = driver.window.workbench().saving();
        driver.run(() -> {
            saving.save();
            saving.afterSaving(() -> left.complete(SceneReader.read(start)));
            assertThat(left).isNotDone();
        });
        driver.await(left::isDone);
        assertThat(left.join()).isEqualTo(changed);
        assertThat(dialog("save-question")).isEmpty();
    }

    @Test
    void whatIsEditedWhileTheFileIsWrittenIsAskedAboutToo() {
        Path start = folder.resolve("scenes").resolve("start.json");
        change();
        CompletableFuture<Scene> left = new CompletableFuture<>();
        driver.run(() -> driver.window.workbench().saving().afterSaving(() -> left.complete(SceneReader.read(start))));
        DialogPane first = awaitDialog("save-question");
        driver.run(() -> {
            WindowDriver.press(first, "Save");
            // Nothing is told to this thread before it is done here.
            change();
        });
        driver.await(() -> left.isDone() || dialog("save-question").isPresent());
        assertThat(left).isNotDone();
        Scene changed = scene();
        answer(awaitDialog("save-question"), "Save");
        driver.await(left::isDone);
        assertThat(left.join()).isEqualTo(changed);
    }

    @Test
    void aFileThatAnotherProgramHasChangedIsNotOverwrittenUnasked() throws IOException {
        Path start = folder.resolve("scenes").resolve("start.json");
        String theirs = Files.readString(start).replace("\"bounces\": ", "\"bounces\": 1");
        Files.writeString(start, theirs);
        change();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        answer(awaitDialog("overwrite-question"), "Cancel");
        assertThat(start).hasContent(theirs);

        Path copy = folder.resolve("scenes").resolve("copy.json");
        driver.files.choose(copy);
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        answer(awaitDialog("overwrite-question"), "Save as…");
        driver.await(() -> driver.studio.document().file().equals(copy));
        assertThat(start).hasContent(theirs);
    }

    @Test
    void whoWantsToOverwriteAnotherProgramsChangesIsAskedOnce() throws IOException {
        Path start = folder.resolve("scenes").resolve("start.json");
        Files.writeString(start, "something else");
        change();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        answer(awaitDialog("overwrite-question"), "Overwrite");
        driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        assertThat(SceneReader.read(start)).isEqualTo(scene());

        change();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        assertThat(SceneReader.read(start)).isEqualTo(scene());
    }

    @Test
    void savingTwiceInARowAsksNothing() {
        Path start = folder.resolve("scenes").resolve("start.json");
        driver.run(() -> {
            SceneSaving saving = driver.window.workbench().saving();
            change();
            saving.save();
            change();
            saving.save();
        });
        driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        assertThat(dialog("overwrite-question")).isEmpty();
        assertThat(SceneReader.read(start)).isEqualTo(scene());
    }

    @Test
    void aFileThatIsGoneIsWrittenAnew() throws IOException {
        Path start = folder.resolve("scenes").resolve("start.json");
        Files.delete(start);
        change();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        assertThat(SceneReader.read(start)).isEqualTo(scene());
    }

    @Test
    void shippedScenesAreNotWrittenTo() throws IOException {
        Path shipped = Path.of("scenes", "teaching.json").toAbsolutePath();
        byte[] before = Files.readAllBytes(shipped);
        Path mine = folder.resolve("scenes").resolve("mine.json");
        driver.run(() -> driver.studio.show(driver.studio.assets().readScene(shipped)));
        change();
        driver.typeWith(KeyCode.Q, KeyCode.CONTROL);
        driver.files.choose(shipped);
        answer(awaitDialog("save-question"), "Save as…");
        assertThat(driver.files.suggested().orElseThrow().getParent())
                .isEqualTo(Path.of("").toAbsolutePath());
        answer(awaitDialog("complaint"), "OK");

        driver.files.choose(mine);
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        driver.await(() -> driver.studio.document().file().equals(mine));
        assertThat(SceneReader.read(mine)).isEqualTo(scene());
        assertThat(shipped).hasBinaryContent(before);
    }

    @Tag("slow")
    @Test
    void aSceneWhoseSkyIsMissingIsOpenedWithAnother() throws IOException {
        Path file = Files.writeString(
                folder.resolve("scenes").resolve("no-sky.json"),
                Files.readString(Path.of("scenes", "teaching.json")).replace("day.hdr", "night.hdr"));
        Path sky = Files.copy(Path.of("skyboxes", "sunset.hdr"), folder.resolve("evening.hdr"));
        Path before = scene().sky().file();
        drop(file);
        DialogPane question = awaitDialog("sky-question");
        assertThat(question.getContentText()).isEqualTo(commandLinesMessage(file));
        answer(question, "Use the present sky");
        driver.await(() -> driver.studio.document().file().equals(file));
        assertThat(scene().sky().file()).isEqualTo(before);
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .changed())
                .isTrue();

        driver.files.choose(sky);
        drop(file);
        answer(awaitDialog("save-question"), "Don't save");
        answer(awaitDialog("sky-question"), "Choose a sky…");
        driver.await(() -> driver.studio.scene().sky().file().equals(sky));
    }

    @Test
    void aCopyElsewhereHasItsOwnNameAndNoSchemaThatIsNotThere() throws IOException {
        Path copy = Files.createDirectories(folder.resolve("mine")).resolve("my room.json");
        driver.files.choose(copy);
        driver.typeWith(KeyCode.S, KeyCode.CONTROL, KeyCode.SHIFT);
        driver.await(() -> driver.studio.document().file().equals(copy));

        assertThat(copy).content().doesNotContain("$schema");
        assertThat(scene().title().name()).isEqualTo("my room");
        assertThat(SceneReader.read(copy)).isEqualTo(scene());
    }

    @Test
    void aFileThatIsOpenedIsReadAfterTheQuestionAboutChanges() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.json"), "{");
        change();
        drop(broken);
        answer(awaitDialog("save-question"), "Don't save");
        answer(awaitDialog("complaint"), "OK");
    }

    @Test
    void aNewSceneIsAFloorASkyAndALightAndAsksWhereToSaveIt() {
        driver.type(Command.NEW.keys());
        assertThat(scene().bodies()).isEqualTo(SceneBodies.NONE);
        assertThat(scene().rendering().integrator()).isEqualTo(Integrator.PATH);
        driver.awaitCurrentPicture();
        Path mine = folder.resolve("scenes").resolve("mine.json");
        driver.files.choose(mine);
        driver.type(Command.SAVE.keys());
        driver.await(() -> driver.studio.document().file().equals(mine));
        assertThat(SceneReader.read(mine)).isEqualTo(scene());
        assertThat(scene().title().name()).isEqualTo("mine");
    }

    @Test
    void theGalleryOpensAShippedScene() {
        driver.type(Command.GALLERY.keys());
        driver.await(() -> tile("spheres-100").isPresent());
        driver.run(() -> tile("spheres-100").orElseThrow().fire());
        driver.await(() -> driver.studio.document().file().endsWith("spheres-100.json"));
    }

    private static Optional<Button> tile(String name) {
        return Window.getWindows().stream()
                .flatMap(window -> window.getScene().getRoot().lookupAll(".gallery-tile").stream())
                .map(Button.class::cast)
                .filter(button -> button.getText().equals(name))
                .findFirst();
    }

    @Test
    void nameAndDescriptionAreEdited() {
        driver.type(Command.TITLE.keys());
        DialogPane dialog = awaitDialog("title-dialog");
        driver.run(() -> {
            ((TextField) dialog.lookup("#title-name")).setText("mine");
            ((TextArea) dialog.lookup("#title-description")).setText("Of my own.");
        });
        answer(dialog, "OK");
        assertThat(scene().title()).isEqualTo(new Title("mine", "Of my own."));
    }

    @Test
    void theSchemaThatAFileNamesIsKept() throws IOException {
        Path named = folder.resolve("scenes").resolve("start.json");
        change();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        driver.await(() -> !driver.studio.document().editsProperty().get().changed());
        assertThat(named).content().contains("\"$schema\": \"scene.schema.json\"");
        Path copy = folder.resolve("scenes").resolve("copy.json");
        driver.files.choose(copy);
        driver.typeWith(KeyCode.S, KeyCode.CONTROL, KeyCode.SHIFT);
        driver.await(() -> driver.studio.document().file().equals(copy));
        assertThat(copy).content().contains("\"$schema\": \"scene.schema.json\"");
    }

    @Test
    void closingAsksToo() {
        change();
        driver.typeWith(KeyCode.Q, KeyCode.CONTROL);
        answer(awaitDialog("save-question"), "Cancel");
        assertThat(driver.stage.isShowing()).isTrue();
        driver.run(() -> driver.stage.fireEvent(new WindowEvent(driver.stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
        answer(awaitDialog("save-question"), "Cancel");
        assertThat(driver.stage.isShowing()).isTrue();
    }

    @Test
    void aNumberThatIsTypedAndNotEnteredIsSavedOrAskedAbout() {
        Path start = folder.resolve("scenes").resolve("start.json");
        typeExposure("2.5");
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        driver.await(() -> driver.notice().equals("Saved " + start));
        assertThat(SceneReader.read(start).rendering().exposure()).isEqualTo(2.5);
        typeExposure("1.5");
        driver.run(() -> driver.stage.fireEvent(new WindowEvent(driver.stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
        answer(awaitDialog("save-question"), "Cancel");
        assertThat(scene().rendering().exposure()).isEqualTo(1.5);
        driver.type(Command.PANEL.keys());
    }

    @Test
    void whatIsNoNumberIsNotLeftAlone() {
        typeExposure("much");
        driver.typeWith(KeyCode.Q, KeyCode.CONTROL);
        assertThat(driver.notice()).startsWith("Exposure is 'much', but must be a number");
        assertThat(driver.stage.isShowing()).isTrue();
        driver.clearNotice();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL);
        assertThat(driver.notice()).startsWith("Exposure is 'much', but must be a number");
        driver.type(KeyCode.ESCAPE);
        driver.type(Command.PANEL.keys());
    }

    /** Leaves the field with the text in it as somebody does who has not pressed Enter. */
    private static void typeExposure(String text) {
        driver.typeWith(KeyCode.X, KeyCode.ALT);
        driver.type(KeyCode.TAB);
        driver.run(() -> {
            TextField field = (TextField) driver.stage.getScene().getFocusOwner();
            field.selectAll();
            field.replaceSelection(text);
        });
    }

    @Test
    void aSceneThatCannotBeSavedIsSaidAndNotTakenForSaved() {
        change();
        driver.files.choose(folder.resolve("nowhere").resolve("x.json"));
        driver.typeWith(KeyCode.S, KeyCode.CONTROL, KeyCode.SHIFT);
        DialogPane dialog = awaitDialog("complaint");
        assertThat(dialog.getContentText()).contains("there is no folder to write it in");
        answer(dialog, "OK");
        assertThat(WindowDriver.call(driver.studio.document().editsProperty()::get)
                        .changed())
                .isTrue();
    }

    @Tag("slow")
    @Test
    void aDaylightSkyIsWrittenBesideTheScene() {
        Path own = folder.resolve("evening.json");
        driver.files.choose(own);
        DaylightFile evening = new DaylightFile(8, -60, 3, 0);
        driver.run(() -> {
            driver.studio.edit("sky", evening::in);
            driver.studio.endGesture();
        });
        driver.awaitCurrentPicture();
        driver.typeWith(KeyCode.S, KeyCode.CONTROL, KeyCode.SHIFT);
        driver.await(() -> driver.studio.document().file().equals(own));

        Path sky = folder.resolve(evening.name());
        assertThat(SceneReader.read(own).sky().file()).isEqualTo(sky);
        assertThat(SkyboxReader.read(sky, _ -> {}).width()).isEqualTo(ShippedSky.WIDTH);
    }

    @Test
    void aDroppedPanoramaBecomesTheSky() throws IOException {
        Path sunset = Files.copy(Path.of("skyboxes", "sunset.hdr"), folder.resolve("evening.hdr"));
        int[] before = driver.awaitCurrentPicture().frame().argb().clone();
        drop(sunset);
        driver.await(() -> driver.studio.scene().sky().file().equals(sunset));
        assertThat(driver.awaitCurrentPicture().frame().argb()).isNotEqualTo(before);
        driver.typeWith(KeyCode.Z, KeyCode.CONTROL);
        assertThat(scene().sky().file().getFileName()).hasToString("day.hdr");
    }

    @Test
    void aSkyThatIsRefusedDoesNotStayInItsBox() throws IOException {
        Path broken = Files.writeString(folder.resolve("aaa.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 9");
        ComboBox<?> box = WindowDriver.call(() -> {
            Panel panel = driver.window.workbench().panel();
            panel.offerSkies(List.of(broken));
            return (ComboBox<?>) panel.rows().stream()
                    .filter(row -> row.name().equals("Sky"))
                    .findFirst()
                    .orElseThrow()
                    .firstControl();
        });
        driver.run(() -> box.getSelectionModel().select(box.getItems().indexOf(broken)));
        answer(awaitDialog("complaint"), "OK");
        assertThat((Path) WindowDriver.call(box::getValue))
                .isEqualTo(scene().sky().file());
    }

    @Test
    void aScreenshotIsThePictureThatIsShown() throws IOException {
        driver.run(() -> driver.studio.refiningProperty().set(false));
        DrawnPicture shown = driver.awaitCurrentPicture();
        Path png = folder.resolve("shot.png");
        driver.files.choose(png);
        driver.type(KeyCode.F12);
        driver.await(() -> Files.exists(png));
        BufferedImage read = ImageIO.read(png.toFile());
        assertThat(read.getWidth()).isEqualTo(shown.frame().width());
        int x = read.getWidth() / 2;
        int y = read.getHeight() / 2;
        assertThat(read.getRGB(x, y)).isEqualTo(shown.frame().argb()[y * read.getWidth() + x]);
        assertThat(driver.files.suggested().orElseThrow().getFileName()).hasToString("twister-1.png");

        Path hdr = folder.resolve("shot.hdr");
        driver.files.choose(hdr);
        driver.type(KeyCode.F12);
        driver.await(() -> Files.exists(hdr));
        assertThat(SkyboxReader.read(hdr).width()).isEqualTo(shown.frame().width());
    }

    @Test
    void anHdrScreenshotHasTheSamplesThatWereGathered() {
        DrawnPicture shown = driver.awaitRest();
        Path hdr = folder.resolve("rest.hdr");
        driver.files.choose(hdr);
        driver.type(KeyCode.F12);
        driver.await(() -> Files.exists(hdr));
        float[] radiance = SkyboxReader.read(hdr).radiance();
        float[] values = shown.input().view().frame();
        int[] argb = shown.frame().argb();
        for (int pixel = 0; pixel < argb.length; pixel++) {
            int green = Tone.quantized(
                    radiance[3 * pixel + 1],
                    values[Layout.EXPOSURE_SCALE],
                    (int) values[Layout.TONE_MAP],
                    values[Layout.SRGB]);
            // A Radiance file has 8 bits for the largest channel, and fewer for the others.
            assertThat(green).isCloseTo(argb[pixel] >> 8 & 0xFF, within(3));
        }
    }

    @Test
    void aSceneIsSavedWhileAnHdrScreenshotWaitsForTheEngine() {
        Path start = folder.resolve("scenes").resolve("start.json");
        Path hdr = folder.resolve("waiting.hdr");
        CountDownLatch drawing = new CountDownLatch(1);
        CompletableFuture<String> drawn = new CompletableFuture<>();
        driver.run(() -> driver.studio.watch(_ -> {
            drawing.countDown();
            drawn.join();
        }));
        change();
        try {
            driver.await(() -> drawing.getCount() == 0);
            driver.files.choose(hdr);
            driver.type(KeyCode.F12);
            driver.typeWith(KeyCode.S, KeyCode.CONTROL);
            driver.await(() -> !driver.studio.document().editsProperty().get().changed());
            assertThat(hdr).doesNotExist();
        } finally {
            driver.run(driver.studio::unwatch);
            drawn.complete("");
        }
        driver.await(() -> driver.notice().equals("Saved " + hdr));
        assertThat(SceneReader.read(start)).isEqualTo(scene());
        assertThat(hdr).exists();
    }

    @Test
    void aScreenshotThatCannotBeWrittenIsSaid() {
        driver.files.choose(folder.resolve("nowhere").resolve("shot.png"));
        driver.type(KeyCode.F12);
        DialogPane dialog = awaitDialog("complaint");
        assertThat(dialog.getContentText()).contains("there is no folder");
        answer(dialog, "OK");
    }

    @Tag("slow")
    @Test
    void picturesAreRecordedUntilStopped() throws IOException {
        Path frames = Files.createDirectory(folder.resolve("frames"));
        driver.files.choose(frames);
        driver.typeWith(KeyCode.R, KeyCode.CONTROL);
        driver.await(() -> driver.notice().startsWith("Recording"));
        change();
        driver.awaitCurrentPicture();
        change();
        driver.awaitCurrentPicture();
        // A picture that is seen is about to be recorded.
        driver.await(() -> Files.exists(frames.resolve("frame-000003.png")));
        driver.typeWith(KeyCode.R, KeyCode.CONTROL);
        driver.await(() -> driver.notice().startsWith("Recorded"));
        DrawnPicture last = driver.awaitCurrentPicture();
        BufferedImage first = ImageIO.read(frames.resolve("frame-000001.png").toFile());
        assertThat(first.getWidth()).isEqualTo(last.frame().width());
    }

    @Test
    void recordingNeedsAFolder() {
        driver.files.choose(folder.resolve("nowhere"));
        driver.typeWith(KeyCode.R, KeyCode.CONTROL);
        DialogPane dialog = awaitDialog("complaint");
        assertThat(dialog.getContentText()).contains("there is no such folder");
        answer(dialog, "OK");
    }

    @Test
    void aRecordingThatStartsAfterTheEndEndsAtOnce() throws IOException {
        Path frames = Files.createDirectory(folder.resolve("frames"));
        driver.files.choose(frames);
        AtomicBoolean passed = new AtomicBoolean();
        try (BackgroundTasks tasks = new BackgroundTasks()) {
            PictureActions pictures = new PictureActions(driver.studio, driver.files, new Dialogs(driver.stage), tasks);
            driver.run(() -> {
                pictures.toggleRecording();
                pictures.finish();
                tasks.run(() -> "", _ -> passed.set(true), _ -> {});
            });
            driver.await(passed::get);
            assertThat(pictures.recorderProperty().get()).isEmpty();
        }
        assertThat(frames).isEmptyDirectory();
    }
}
