package dev.twister.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.VariableTree;
import dev.twister.engine.vector.made.PathColumns;
import dev.twister.kernel.Layout;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The kernel's methods of numbers and of the path alone, in lanes, do what they do, in every bit. */
final class KernelMethodsTest {
    private static final Sources SOURCES = sources();

    static Stream<String> names() {
        return SOURCES.methods().stream()
                .filter(method -> method.tree().getReturnType() != null)
                .filter(method -> method.tree().getParameters().stream().allMatch(KernelMethodsTest::isKnown))
                .filter(method ->
                        !method.owner().equals("Layout") && !method.owner().equals("Tone"))
                .map(Sources.Method::name)
                .filter(name -> !isPlacedByCallers(name))
                .sorted()
                .distinct();
    }

    private static Sources sources() {
        try (Stream<Path> files = Files.list(Path.of("src/main/java/dev/twister/kernel"))) {
            return Sources.parse(files.toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean isKnown(VariableTree parameter) {
        String type = parameter.getType().toString();
        String name = parameter.getName().toString();
        return !name.equals("variant") && (type.equals("int") || type.equals("float") || name.equals("path"));
    }

    /** Whether an int parameter is a place in the path, which must be a constant. */
    private static boolean isPlacedByCallers(String name) {
        try {
            new Root(SOURCES, "made", "Made", SOURCES.method(name), Layout.FINISHED_PATH_LENGTH, List.of(0));
            return false;
        } catch (Refusal refusal) {
            if (refusal.getMessage().contains("methods " + name)
                    || refusal.getMessage().contains("the path at a place that is not a constant")) {
                return true;
            }
            throw refusal;
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void isTheSameInLanes(String name) throws Throwable {
        Sources.Method method = SOURCES.method(name);
        Method scalar = Arrays.stream(
                        Class.forName("dev.twister.kernel." + method.owner()).getDeclaredMethods())
                .filter(declared ->
                        declared.getName().equals(method.tree().getName().toString()))
                .findFirst()
                .orElseThrow();
        scalar.setAccessible(true);
        MadeMethod made = new MadeMethod(SOURCES, method, Layout.FINISHED_PATH_LENGTH, List.of(0));
        Random random = new Random(name.hashCode());
        for (int round = 0; round < 8; round++) {
            check(scalar, made, random);
        }
    }

    private static void check(Method scalar, MadeMethod made, Random random) throws Throwable {
        PathColumns columns = made.columns;
        float[][] paths = new float[PathColumns.WIDTH][Layout.FINISHED_PATH_LENGTH];
        Object[] results = new Object[PathColumns.WIDTH];
        for (int lane = 0; lane < PathColumns.WIDTH; lane++) {
            List<Object> arguments = new ArrayList<>();
            int ints = 1;
            int floats = Layout.FINISHED_PATH_LENGTH + 1;
            for (int k = 0; k < Layout.FINISHED_PATH_LENGTH; k++) {
                paths[lane][k] = number(random);
                columns.floats[columns.floatAt(lane, k)] = paths[lane][k];
            }
            for (Class<?> type : scalar.getParameterTypes()) {
                if (type == int.class) {
                    int number = random.nextInt(1 << 15);
                    columns.ints[columns.intAt(lane, ints++)] = number;
                    arguments.add(number);
                } else if (type == float.class) {
                    float number = number(random);
                    columns.floats[columns.floatAt(lane, floats++)] = number;
                    arguments.add(number);
                } else {
                    arguments.add(paths[lane]);
                }
            }
            results[lane] = scalar.invoke(null, arguments.toArray());
        }
        made.run((1 << PathColumns.WIDTH) - 1);
        for (int lane = 0; lane < PathColumns.WIDTH; lane++) {
            for (int k = 0; k < Layout.FINISHED_PATH_LENGTH; k++) {
                MadeMethod.assertSame(columns.floats[columns.floatAt(lane, k)], paths[lane][k]);
            }
            switch (results[lane]) {
                case Float result ->
                    MadeMethod.assertSame(columns.floats[columns.floatAt(lane, Layout.FINISHED_PATH_LENGTH)], result);
                case Integer result ->
                    assertThat(columns.ints[columns.intAt(lane, 0)]).isEqualTo(result);
                case null, default -> {}
            }
        }
    }

    private static float number(Random random) {
        return random.nextInt(8) == 0 ? random.nextInt(-1, 2) : random.nextFloat(-2, 2);
    }
}
