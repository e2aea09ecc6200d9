package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import org.junit.jupiter.api.Test;

class TornadoKernelTest {
    @Test
    void noMethodHasMoreThanTenParameters() {
        assertThat(TornadoKernel.class.getDeclaredMethods())
                .isNotEmpty()
                .allSatisfy((Method method) -> assertThat(method.getParameterCount())
                        .as(method.getName())
                        .isLessThanOrEqualTo(10));
    }
}
