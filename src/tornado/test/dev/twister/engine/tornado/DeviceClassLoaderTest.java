package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassModel;
import java.lang.classfile.instruction.InvokeInstruction;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The bytecode that a compiler reads from class files, as TornadoVM 6 does; earlier versions ask the JVM. */
class DeviceClassLoaderTest {
    private final ClassLoader loader = DeviceClassLoader.load(HelperKernels.class, HelperTasks.class)
            .getClass()
            .getClassLoader();

    @Test
    void theKernelsClassFilesHaveNoSquareRootOfADouble() throws IOException {
        int roots = 0;
        for (String file : kernelClassFiles()) {
            List<String> calls = calls(read(file));
            assertThat(calls).as("calls in %s", file).doesNotContain("java/lang/Math.sqrt(D)D");
            roots += (int) calls.stream()
                    .filter("uk/ac/manchester/tornado/api/math/TornadoMath.sqrt(F)F"::equals)
                    .count();
        }
        assertThat(roots).isPositive();
    }

    @Test
    void otherClassFilesAreAsTheyAre() throws IOException {
        String file = "dev/twister/world/FrameInput.class";
        try (InputStream untouched = getClass().getClassLoader().getResourceAsStream(file)) {
            assertThat(read(file)).isEqualTo(untouched.readAllBytes());
        }
        assertThat(loader.getResourceAsStream("dev/twister/kernel/NoSuchClass.class"))
                .isNull();
    }

    private byte[] read(String file) throws IOException {
        try (InputStream stream = loader.getResourceAsStream(file)) {
            return stream.readAllBytes();
        }
    }

    private static List<String> kernelClassFiles() throws IOException {
        Path classes = Path.of("target/classes");
        try (Stream<Path> files = Files.list(classes.resolve("dev/twister/kernel"))) {
            return files.map(file -> classes.relativize(file).toString().replace('\\', '/'))
                    .filter(file -> file.endsWith(".class"))
                    .toList();
        }
    }

    private static List<String> calls(byte[] classFile) {
        ClassModel model = ClassFile.of().parse(classFile);
        return model.methods().stream()
                .flatMap(method -> method.code().stream())
                .flatMap(code -> code.elementStream())
                .filter(InvokeInstruction.class::isInstance)
                .map(InvokeInstruction.class::cast)
                .map(call -> call.owner().asInternalName() + "." + call.name().stringValue()
                        + call.type().stringValue())
                .toList();
    }
}
