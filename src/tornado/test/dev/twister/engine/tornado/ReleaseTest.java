package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import uk.ac.manchester.tornado.api.exceptions.TornadoRuntimeException;

class ReleaseTest {
    @Test
    void errorsAndExceptionsOfTornadoAreNotPassedOn() {
        assertThatCode(() -> Release.quietly(() -> {
                    throw new AssertionError("should not reach here: a lost device");
                }))
                .doesNotThrowAnyException();
        assertThatCode(() -> Release.quietly(() -> {
                    throw new TornadoRuntimeException("a lost device");
                }))
                .doesNotThrowAnyException();
    }

    @Test
    void errorsOfTheJvmArePassedOn() {
        assertThatThrownBy(() -> Release.quietly(() -> {
                    throw new OutOfMemoryError();
                }))
                .isInstanceOf(OutOfMemoryError.class);
    }
}
