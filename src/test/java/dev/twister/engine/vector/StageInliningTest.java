package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.management.ObjectName;
import org.junit.jupiter.api.Test;

/**
 * The launcher and the engine give the compiler the same inlining options for stages; the engine sets them in a JVM
 * started without them, such as that of the tests.
 */
final class StageInliningTest {
    private static final String COMMAND = "-XX:CompileCommand=";

    @Test
    void isWhatTheLauncherTells() throws Exception {
        List<String> options = Files.readAllLines(Path.of("scripts", "engine.options"));
        assertThat(options).contains(commands("inline,", StageInlining.ALWAYS));
        assertThat(options).contains(commands("dontinline,", StageInlining.NEVER));
    }

    private static String[] commands(String kind, List<String> methods) {
        return methods.stream().map(method -> COMMAND + kind + method).toArray(String[]::new);
    }

    @Test
    void isToldWhereTheLauncherHasNot() throws Exception {
        assertThat(ManagementFactory.getRuntimeMXBean().getInputArguments())
                .noneMatch(argument -> argument.startsWith(COMMAND));
        VectorEngines.open(1).close();
        Object directives = ManagementFactory.getPlatformMBeanServer()
                .invoke(
                        new ObjectName("com.sun.management:type=DiagnosticCommand"),
                        "compilerDirectivesPrint",
                        new Object[0],
                        new String[0]);
        assertThat(directives.toString()).contains("dev/twister/engine/vector/*.*");
    }
}
