package dev.twister.engine.vector;

import static org.assertj.core.api.Assumptions.assumeThat;

import dev.twister.engine.Engine;
import dev.twister.engine.vector.lanes.Lanes;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntPredicate;
import jdk.incubator.vector.FloatVector;

/**
 * Loads the engine's classes once per vector width other than the CPU's, as the lane count is a class constant. All
 * other classes come from the parent loader. Tests of one width share its classes, and with them the compiled code.
 */
final class WidthLoader extends ClassLoader {
    private static final String PACKAGE = VectorEngines.class.getPackageName() + ".";

    /** Whether all widths are asked for; such a run also compares more scenes. */
    static final boolean ALL = "all".equals(System.getProperty("twister.widths"));

    /**
     * Vector widths in bits at which pictures are compared: the CPU's own, or 128, 256 and 512 with
     * {@code -Dtwister.widths=all}. Tests of other widths are skipped.
     */
    static final List<Integer> WIDTHS = ALL ? List.of(128, 256, 512) : List.of(ownBits());

    /** The width at which all other tests run; its compiled code serves them all. */
    private static final Map<String, String> OWN = Map.of(Lanes.BITS_PROPERTY, Integer.toString(ownBits()));

    private static final Map<Map<String, String>, WidthLoader> LOADERS = new ConcurrentHashMap<>();

    private static int ownBits() {
        return Math.clamp(FloatVector.SPECIES_PREFERRED.vectorBitSize(), 128, 512);
    }

    private WidthLoader() {
        super(WidthLoader.class.getClassLoader());
    }

    /**
     * Opens an engine of this vector width.
     *
     * @param bits 128, 256 or 512
     */
    static Engine open(int bits, int threads) {
        return open(width(bits), threads);
    }

    /** Opens an engine that traverses the hierarchy from {@code crowd} bodies on. */
    static Engine openForCrowds(int bits, int threads, int crowd) {
        return open(width(bits), threads, crowd);
    }

    /** Opens an engine that declines some bodies. */
    static Engine openDeclining(int bits, int threads, int crowd, IntPredicate declined) {
        return open(width(bits), threads, crowd, declined);
    }

    /** Opens a four-lane engine as on CPUs without fused multiply-add. */
    static Engine openWithoutFusing(int threads) {
        return openWithoutFusing(threads, VectorEngine.CROWD);
    }

    /** Opens an engine without fused multiply-add that traverses the hierarchy from {@code crowd} bodies on. */
    static Engine openWithoutFusing(int threads, int crowd) {
        return open(Map.of(Lanes.BITS_PROPERTY, "128", Lanes.FMA_PROPERTY, "false"), threads, crowd);
    }

    private static Map<String, String> width(int bits) {
        assumeThat(WIDTHS).as("widths; -Dtwister.widths=all tests all").contains(bits);
        return Map.of(Lanes.BITS_PROPERTY, Integer.toString(bits));
    }

    private static Engine open(Map<String, String> properties, Object... arguments) {
        Properties before = (Properties) System.getProperties().clone();
        System.getProperties().putAll(properties);
        try {
            Class<?> engines = properties.equals(OWN)
                    ? VectorEngines.class
                    : LOADERS.computeIfAbsent(properties, _ -> new WidthLoader())
                            .loadClass(VectorEngines.class.getName());
            Class<?>[] types = Arrays.stream(arguments)
                    .map(argument -> argument instanceof Integer ? int.class : IntPredicate.class)
                    .toArray(Class<?>[]::new);
            var open = engines.getDeclaredMethod("open", types);
            open.setAccessible(true);
            return (Engine) open.invoke(null, arguments);
        } catch (ReflectiveOperationException e) {
            throw new LinkageError("cannot open the engine with " + properties, e);
        } finally {
            System.setProperties(before);
        }
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            if (loaded == null) {
                loaded = name.startsWith(PACKAGE) ? define(name) : super.loadClass(name, resolve);
            }
            return loaded;
        }
    }

    private Class<?> define(String name) {
        try (InputStream file = getResourceAsStream(name.replace('.', '/') + ".class")) {
            byte[] bytes = file.readAllBytes();
            return defineClass(name, bytes, 0, bytes.length);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
