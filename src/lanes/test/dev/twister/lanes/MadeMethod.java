package dev.twister.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.made.PathColumns;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** A scalar method in lanes: made, compiled and loaded. */
final class MadeMethod {
    private static final AtomicInteger CLASSES = new AtomicInteger();

    final PathColumns columns;
    private final MethodHandles.Lookup lookup;
    private final MethodHandle run;

    /** Makes the lanes of a method. */
    MadeMethod(Sources sources, Sources.Method method, int pathLength, List<Integer> variants) throws Throwable {
        lookup = MethodHandles.privateLookupIn(PathColumns.class, MethodHandles.lookup());
        String name = "Made" + CLASSES.incrementAndGet();
        Root root = new Root(sources, PathColumns.class.getPackageName(), name, method, pathLength, variants);
        Class<?> made = lookup.defineClass(compiled(name, root.text));
        run = lookup.findStatic(
                made, "run", MethodType.methodType(void.class, PathColumns.class, int[].class, int.class));
        MethodType counts = MethodType.methodType(void.class, int.class, int.class, int.class, int.class, int.class);
        columns = (PathColumns) lookup.findConstructor(PathColumns.class, counts)
                .invoke(PathColumns.WIDTH, root.floats, root.ints, root.masks, root.lists);
    }

    private static byte[] compiled(String name, String text) throws IOException, URISyntaxException {
        // With the whole class path of the tests, javac looks for each name in every library.
        Path classes = Path.of(PathColumns.class
                .getProtectionDomain()
                .getCodeSource()
                .getLocation()
                .toURI());
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        JavaFileObject source =
                new SimpleJavaFileObject(URI.create("string:///" + name + ".java"), JavaFileObject.Kind.SOURCE) {
                    @Override
                    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                        return text;
                    }
                };
        JavaFileObject result =
                new SimpleJavaFileObject(URI.create("bytes:///" + name + ".class"), JavaFileObject.Kind.CLASS) {
                    @Override
                    public OutputStream openOutputStream() {
                        return bytes;
                    }
                };
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
            ForwardingJavaFileManager<StandardJavaFileManager> memory = new ForwardingJavaFileManager<>(files) {
                @Override
                public JavaFileObject getJavaFileForOutput(
                        Location location, String className, JavaFileObject.Kind kind, javax.tools.FileObject sibling) {
                    return result;
                }
            };
            List<String> options = List.of(
                    "-nowarn", "-proc:none", "--add-modules", "jdk.incubator.vector", "-cp", classes.toString());
            if (!compiler.getTask(null, memory, null, options, null, List.of(source))
                    .call()) {
                throw new IOException("the lanes of " + name + " do not compile");
            }
        }
        return bytes.toByteArray();
    }

    /** Requires the same bits, or any that are not a number. */
    static void assertSame(float actual, float expected) {
        assertThat(Float.floatToIntBits(actual)).isEqualTo(Float.floatToIntBits(expected));
    }

    /** Sets one of the kernel's arguments that lanes share. */
    void share(String name, Class<?> type, Object value) throws Throwable {
        lookup.findSetter(PathColumns.class, name, type).invoke(columns, value);
    }

    /** Runs some of the 16 lanes. */
    void run(int lanes) throws Throwable {
        int packets = PathColumns.WIDTH / Lanes.COUNT;
        int[] list = new int[packets];
        int count = 0;
        for (int packet = 0; packet < packets; packet++) {
            long active = (lanes >> (packet * Lanes.COUNT)) & Lanes.first(Lanes.COUNT);
            columns.activate(packet, active);
            list[count] = packet;
            count += active == 0 ? 0 : 1;
        }
        run.invoke(columns, list, count);
    }
}
