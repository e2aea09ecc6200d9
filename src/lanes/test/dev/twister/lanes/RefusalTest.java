package dev.twister.lanes;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What lanes cannot be made of is refused by name and line. */
final class RefusalTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    if (a > 0) { return 1; }        | a return before the method's end
                    while (a > 0) { break; }        | break: lanes do not know such a statement
                    do { a = a - 1; } while (a > 0); | do_while_loop: lanes do not know such a statement
                    double d = 0;                   | double d: lanes know float, int and the kernel's arrays
                    float y = (float) 0.5;          | 0.5: lanes know ints and floats alone
                    path[a] = 1f;                   | the path at a place that is not a constant
                    frame[0] = 1f;                  | a store to frame, which all lanes share
                    a = a / b;                      | a division of ints by something else than a positive constant
                    x = Math.floor(x);              | Math.floor: lanes know abs, max, min and (float) Math.sqrt
                    x = x % 2f;                     | a remainder of floats
                    a = a > 0 ? store(path) : 0;    | a store inside ?:, && or ||
                    a = other(a);                   | a call of Refused.other, which the kernel does not have
                    a = a >>> 1;                    | lanes do not know this operator
                    a -= 1;                         | lanes know calls, =, +=, ++ and -- here
                    a = Unknown.NUMBER;             | an unknown name: Unknown.NUMBER
                    for (int k = 0; k < 9; k++) { k = k + b; } | the loop's body changes its index k
                    """)
    void isSaidWithItsLine(String statement, String refusal) throws IOException {
        Path file = folder.resolve("Refused.java");
        Files.writeString(file, """
                class Refused {
                    static int method(float[] path, float[] frame, int a, int b, float x) {
                        %s
                        return a;
                    }

                    static int store(float[] path) {
                        path[0] = 1f;
                        return 1;
                    }
                }
                """.formatted(statement));
        Sources sources = Sources.parse(List.of(file));
        int line = refusal.startsWith("a store inside") ? 8 : 3;
        assertThatThrownBy(() -> new Root(sources, "made", "Made", sources.method("Refused.method"), 8, List.of(0)))
                .isInstanceOf(Refusal.class)
                .hasMessageStartingWith("Refused.java:" + line + ": ")
                .hasMessageContaining(refusal);
    }
}
