package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import java.io.IOException;
import java.util.Locale;
import javafx.scene.control.ButtonType;
import org.junit.jupiter.api.Test;

class LanguageTest {
    /** Says what stands on a button, where the system speaks German. */
    static final class GermanMain {
        private GermanMain() {}

        public static void main(String[] arguments) {
            Locale.setDefault(Locale.GERMANY);
            Gui.chooseLanguage();
            System.out.println(ButtonType.CANCEL.getText());
        }
    }

    @Test
    void buttonsAreEnglishEverywhere() throws IOException {
        Process german = ChildJvm.start(ChildJvm.of(GermanMain.class));
        assertThat(german.inputReader().readLine()).isEqualTo("Cancel");
    }
}
