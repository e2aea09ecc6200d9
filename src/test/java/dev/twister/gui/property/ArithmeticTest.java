package dev.twister.gui.property;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ArithmeticTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "1/4; 0.25",
                "2*3; 6",
                "1 + 2 * 3; 7",
                "(1 + 2) * 3; 9",
                "10 - 4 - 3; 3",
                "8/4/2; 1",
                "-1.5; -1.5",
                "--2; 2",
                "-(1+1); -2",
                "0,5; 0.5",
                "1e-3*2; 0.002",
                " 7 ; 7"
            })
    void isComputed(String typed, double value) {
        assertThat(Arithmetic.value(typed)).contains(value);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "many", "1/0", "0/0", "1 2", "(1", "1)", "2*", "NaN", "1e999999999", "1.2.3", "e", "0x10"})
    void anythingElseIsNoNumber(String typed) {
        assertThat(Arithmetic.value(typed)).isEmpty();
    }
}
