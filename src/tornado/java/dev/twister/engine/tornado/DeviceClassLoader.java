package dev.twister.engine.tornado;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassTransform;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.CodeElement;
import java.lang.classfile.instruction.InvokeInstruction;
import java.lang.constant.ClassDesc;
import java.lang.constant.MethodTypeDesc;
import java.util.function.Supplier;
import uk.ac.manchester.tornado.api.math.TornadoMath;

/**
 * Loads copies of the kernel's classes for devices, with float square roots. Java only has a square root of doubles,
 * which TornadoVM compiles literally: devices without doubles could not run it, others would be slow. Because the
 * kernel must not depend on TornadoVM, its calls of {@code Math.sqrt} are replaced by {@link TornadoMath}'s here.
 * TornadoVM's compiler eliminates the surrounding conversions.
 */
final class DeviceClassLoader extends ClassLoader {
    private static final String KERNEL = "dev.twister.kernel.";
    private static final ClassDesc TORNADO_MATH = ClassDesc.of("uk.ac.manchester.tornado.api.math.TornadoMath");
    private static final MethodTypeDesc FLOAT_TO_FLOAT = MethodTypeDesc.ofDescriptor("(F)F");

    private final String entry;

    private DeviceClassLoader(Class<?> entry) {
        super(entry.getClassLoader());
        this.entry = entry.getName();
    }

    /**
     * Creates an instance of a class that is loaded for a device, together with the kernel, and returns what it
     * supplies.
     *
     * @param entry the class with the {@code @Parallel} loops; needs a public constructor without parameters
     * @param supplied an interface that is not reloaded
     */
    static <T> T load(Class<? extends Supplier<T>> entry, Class<T> supplied) {
        try {
            Object supplier = new DeviceClassLoader(entry)
                    .loadClass(entry.getName())
                    .getConstructor()
                    .newInstance();
            return supplied.cast(((Supplier<?>) supplier).get());
        } catch (ReflectiveOperationException e) {
            throw new LinkageError("the kernel could not be loaded for a device: " + e, e);
        }
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!isLoadedAnew(name)) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded != null ? loaded : define(name);
        }
    }

    /** Class files of the kernel in their transformed form: TornadoVM 6 compiles these instead of the JVM's classes. */
    @Override
    public InputStream getResourceAsStream(String name) {
        InputStream stream = super.getResourceAsStream(name);
        if (stream == null || !isLoadedAnew(name.replaceFirst("\\.class$", "").replace('/', '.'))) {
            return stream;
        }
        try (stream) {
            return new ByteArrayInputStream(withFloatRoots(stream.readAllBytes()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private boolean isLoadedAnew(String className) {
        return className.startsWith(KERNEL) || className.equals(entry);
    }

    private Class<?> define(String name) throws ClassNotFoundException {
        try (InputStream stream = getResourceAsStream(name.replace('.', '/') + ".class")) {
            if (stream == null) {
                throw new ClassNotFoundException(name);
            }
            byte[] bytes = stream.readAllBytes();
            return defineClass(name, bytes, 0, bytes.length);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static byte[] withFloatRoots(byte[] bytes) {
        ClassFile format = ClassFile.of();
        return format.transformClass(
                format.parse(bytes), ClassTransform.transformingMethodBodies(DeviceClassLoader::replaceRoot));
    }

    private static void replaceRoot(CodeBuilder code, CodeElement element) {
        if (element instanceof InvokeInstruction call
                && call.owner().asInternalName().equals("java/lang/Math")
                && call.name().equalsString("sqrt")) {
            code.d2f().invokestatic(TORNADO_MATH, "sqrt", FLOAT_TO_FLOAT).f2d();
        } else {
            code.with(element);
        }
    }
}
