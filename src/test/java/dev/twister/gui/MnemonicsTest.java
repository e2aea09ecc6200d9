package dev.twister.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MnemonicsTest {
    @Test
    void theFirstLettersComeFirst() {
        assertThat(Mnemonics.letters(List.of("Open…", "Save", "Save as…", "Screenshot…", "Quit")))
                .containsExactly('o', 's', 'a', 'c', 'q');
    }

    @Test
    void aLetterIsGivenUpForOneThatHasNoOther() {
        assertThat(Mnemonics.letters(List.of("ab", "b", "a"))).containsExactly('a', 'b', Mnemonics.NONE);
        assertThat(Mnemonics.letters(List.of("abc", "b", "a"))).containsExactly('c', 'b', 'a');
        assertThat(Mnemonics.letters(List.of("ab", "bc", "a"))).containsExactly('b', 'c', 'a');
    }

    @Test
    void whatHasNoLetterHasNone() {
        assertThat(Mnemonics.letters(List.of("", "…", "_", "É"))).containsOnly(Mnemonics.NONE);
    }

    @ParameterizedTest
    @CsvSource({
        "Open…, o, _Open…",
        "Full screen, s, Full _screen",
        "Insert mesh…, e, Ins_ert mesh…",
        "Undo: a_b, u, _Undo: a__b",
        "_u, u, ___u",
        "Undo, x, Undo"
    })
    void theLetterIsMarkedAndUnderscoresStay(String label, char letter, String marked) {
        assertThat(Mnemonics.marked(label, letter)).isEqualTo(marked);
    }
}
