package dev.twister.engine.vector.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.ChildJvm;
import java.io.IOException;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Checks that vectors do not straddle cache lines, as {@link Lanes#BORDER} promises, in a launcher-like JVM. */
final class CacheLinesTest {
    private static final int BYTES_A_LINE = 64;

    @Test
    void arraysHaveABorderOfACacheLineWhereLanesSay() throws IOException, InterruptedException {
        Process java = ChildJvm.start(
                ChildJvm.asLaunched(List.of(), Borders.class).redirectError(ProcessBuilder.Redirect.DISCARD));
        String output = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        java.waitFor();
        assertThat(output.lines()).hasSize(2 * 2 * Borders.ARRAYS).containsOnly("0");
    }

    /**
     * Prints how far array borders are from cache-line borders, before and after the garbage collector moves the
     * arrays.
     */
    static final class Borders {
        static final int ARRAYS = 20;

        private Borders() {}

        public static void main(String[] arguments) throws Throwable {
            List<MemorySegment> arrays = new ArrayList<>();
            for (int k = 0; k < ARRAYS; k++) {
                arrays.add(MemorySegment.ofArray(new float[Lanes.BORDER + k]));
                arrays.add(MemorySegment.ofArray(new int[Lanes.BORDER + k]));
            }
            MethodHandle address = address();
            tell(arrays, address);
            System.gc();
            tell(arrays, address);
        }

        /** C's {@code memmove} of zero bytes, which returns its destination address. */
        @SuppressWarnings("restricted") // the returned address is only printed
        private static MethodHandle address() {
            Linker linker = Linker.nativeLinker();
            FunctionDescriptor memmove = FunctionDescriptor.of(
                    ValueLayout.JAVA_LONG, ValueLayout.ADDRESS, ValueLayout.ADDRESS, ValueLayout.JAVA_LONG);
            return linker.downcallHandle(
                    linker.defaultLookup().findOrThrow("memmove"), memmove, Linker.Option.critical(true));
        }

        private static void tell(List<MemorySegment> arrays, MethodHandle address) throws Throwable {
            for (MemorySegment array : arrays) {
                MemorySegment border = array.asSlice((long) Lanes.BORDER * Float.BYTES);
                long at = (long) address.invokeExact(border, border, 0L);
                System.out.println(at % BYTES_A_LINE);
            }
        }
    }
}
