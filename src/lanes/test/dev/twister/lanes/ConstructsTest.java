package dev.twister.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.vector.made.PathColumns;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each construct in lanes does what the scalar method does, in every bit, and nothing in other lanes. */
final class ConstructsTest {
    private static final Path SOURCE = Path.of("src/lanes/test/dev/twister/lanes/Constructs.java");
    private static final int PATH = 8;
    private static final int TABLE = 40;
    private static final int ROUNDS = 12;

    static Stream<String> names() {
        return Arrays.stream(Constructs.class.getDeclaredMethods())
                .filter(method -> !Modifier.isPrivate(method.getModifiers()))
                .map(Method::getName)
                .sorted();
    }

    @ParameterizedTest
    @MethodSource("names")
    void isTheScalarMethod(String name) throws Throwable {
        Method scalar = Arrays.stream(Constructs.class.getDeclaredMethods())
                .filter(method -> method.getName().equals(name))
                .findFirst()
                .orElseThrow();
        Sources sources = Sources.parse(List.of(SOURCE));
        MadeMethod made = new MadeMethod(sources, sources.method("Constructs." + name), PATH, List.of(0, 2, 4, 6));
        Random random = new Random(name.hashCode());
        for (int round = 0; round < ROUNDS; round++) {
            check(scalar, made, random, 2 * (round % 4));
        }
    }

    private static void check(Method scalar, MadeMethod made, Random random, int variant) throws Throwable {
        float[] frame = numbers(random, TABLE);
        made.share("frame", float[].class, frame);
        made.share("variant", int.class, variant);
        int active = random.nextInt(1 << PathColumns.WIDTH);
        float[][] paths = new float[PathColumns.WIDTH][];
        float[][] scratches = new float[PathColumns.WIDTH][];
        Object[] results = new Object[PathColumns.WIDTH];
        PathColumns columns = made.columns;
        for (int lane = 0; lane < PathColumns.WIDTH; lane++) {
            paths[lane] = numbers(random, PATH);
            scratches[lane] = numbers(random, TABLE);
            int a = random.nextInt(32);
            int b = random.nextInt(32);
            float x = numbers(random, 1)[0];
            for (int k = 0; k < PATH; k++) {
                columns.floats[columns.floatAt(lane, k)] = paths[lane][k];
            }
            for (int k = 0; k < TABLE; k++) {
                columns.scratch[columns.scratchAt(lane, k)] = scratches[lane][k];
            }
            columns.ints[columns.intAt(lane, 1)] = a;
            columns.ints[columns.intAt(lane, 2)] = b;
            columns.floats[columns.floatAt(lane, PATH + 1)] = x;
            if ((active >> lane & 1) != 0) {
                results[lane] = scalar.invoke(null, paths[lane], scratches[lane], frame, a, b, x, variant);
            }
        }
        made.run(active);
        for (int lane = 0; lane < PathColumns.WIDTH; lane++) {
            for (int k = 0; k < PATH; k++) {
                MadeMethod.assertSame(columns.floats[columns.floatAt(lane, k)], paths[lane][k]);
            }
            for (int k = 0; k < TABLE; k++) {
                MadeMethod.assertSame(columns.scratch[columns.scratchAt(lane, k)], scratches[lane][k]);
            }
            switch (results[lane]) {
                case Float result -> MadeMethod.assertSame(columns.floats[columns.floatAt(lane, PATH)], result);
                case Integer result ->
                    assertThat(columns.ints[columns.intAt(lane, 0)]).isEqualTo(result);
                case null, default -> {}
            }
        }
    }

    private static float[] numbers(Random random, int count) {
        float[] numbers = new float[count];
        for (int k = 0; k < count; k++) {
            numbers[k] = random.nextInt(8) == 0 ? random.nextInt(-1, 2) : random.nextFloat(-2, 2);
        }
        return numbers;
    }
}
