package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.controls.Dialogs;
import dev.twister.gui.controls.Dialogs.Answer;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Enter presses the default button of every question. */
class DialogsTest {
    private static WindowDriver driver;

    @BeforeAll
    static void open() {
        driver = WindowDriver.open();
    }

    @AfterAll
    static void close() {
        driver.close();
    }

    /** A question, and what its default button does. */
    enum Question {
        SAVE(
                "save-question",
                List.of("usual"),
                (dialogs, done) -> dialogs.askToSave("a.json", answer("usual", done), answer("other", done))),
        OVERWRITE(
                "overwrite-question",
                List.of("usual"),
                (dialogs, done) -> dialogs.askToOverwrite("a.json", answer("usual", done), answer("other", done))),
        SKY(
                "sky-question",
                List.of("usual"),
                (dialogs, done) -> dialogs.askForSky("a.hdr", answer("usual", done), answer("other", done))),
        RESTORE(
                "restore-question",
                List.of("usual"),
                (dialogs, done) -> dialogs.askToRestore(
                        "a.json", Instant.EPOCH, answer("usual", done), answer("other", done), answer("later", done))),
        FRAMES(
                "frames-question",
                List.of("usual"),
                (dialogs, done) -> dialogs.askToReplaceFrames("f.png", answer("usual", done), answer("other", done))),
        RENDER(
                "render-question",
                List.of(),
                (dialogs, done) -> dialogs.askToCancelRender("a.mp4", answer("other", done))),
        COMPLAINT("complaint", List.of(), (dialogs, _) -> dialogs.complain("Couldn't open the scene", "a.json"));

        private final String id;

        @SuppressWarnings("ImmutableEnumChecker") // immutable
        private final List<String> usual;

        @SuppressWarnings("ImmutableEnumChecker") // asks
        private final BiConsumer<Dialogs, List<String>> ask;

        Question(String id, List<String> usual, BiConsumer<Dialogs, List<String>> ask) {
            this.id = id;
            this.usual = usual;
            this.ask = ask;
        }

        private static Answer answer(String label, List<String> done) {
            return new Answer(label, () -> done.add(label));
        }
    }

    @ParameterizedTest
    @EnumSource
    void enterPressesTheDefaultButton(Question question) {
        List<String> done = new ArrayList<>();
        driver.run(() -> question.ask.accept(new Dialogs(driver.stage), done));
        driver.awaitDialog(question.id);
        driver.pulse();
        driver.type(KeyCode.ENTER);
        driver.await(() -> driver.dialog(question.id).isEmpty());

        assertThat(WindowDriver.call(() -> List.copyOf(done))).isEqualTo(question.usual);
    }
}
