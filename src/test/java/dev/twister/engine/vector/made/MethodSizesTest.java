package dev.twister.engine.vector.made;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.lang.classfile.ClassFile;
import java.lang.classfile.MethodModel;
import java.lang.classfile.attribute.CodeAttribute;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks that the JVM compiles the lanes that are made of the kernel: larger methods it only interprets. */
final class MethodSizesTest {
    /** HotSpot's HugeMethodLimit, in bytes of bytecode. */
    private static final int MOST_BYTES = 8000;

    @ParameterizedTest
    @ValueSource(classes = {StartLanes.class, FindLanes.class, ArriveLanes.class, LightLanes.class})
    void everyMethodIsCompiled(Class<?> lanes) throws IOException {
        try (InputStream file = lanes.getResourceAsStream(lanes.getSimpleName() + ".class")) {
            assertThat(ClassFile.of().parse(file.readAllBytes()).methods())
                    .isNotEmpty()
                    .allSatisfy(method -> assertThat(bytes(method))
                            .as(method.methodName().stringValue())
                            .isLessThan(MOST_BYTES));
        }
    }

    private static int bytes(MethodModel method) {
        return method.code().map(code -> ((CodeAttribute) code).codeLength()).orElse(0);
    }
}
