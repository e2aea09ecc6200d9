package dev.twister.denoise;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemoryLayout;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.SymbolLookup;
import java.lang.foreign.ValueLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Functions of the library, by their names in C. */
@SuppressWarnings("restricted") // native functions
final class OidnFunctions {
    private final SymbolLookup library;

    /**
     * Loads the library. It stays loaded until the JVM ends, because its threads do.
     *
     * @param place a file, or a name for the system's loader
     * @throws DenoiseException if it cannot be loaded
     */
    OidnFunctions(String place) {
        try {
            library = SymbolLookup.libraryLookup(place, Arena.global());
        } catch (IllegalArgumentException problem) {
            throw new DenoiseException("cannot be loaded; it is damaged, or for another system or processor", problem);
        }
    }

    boolean has(String function) {
        return library.find(function).isPresent();
    }

    /** Calls a function without a result. */
    void run(String function, Object... arguments) {
        call(Optional.empty(), function, arguments);
    }

    /** Calls a function whose result is an int. */
    int number(String function, Object... arguments) {
        return (int) call(Optional.of(ValueLayout.JAVA_INT), function, arguments);
    }

    /** Calls a function whose result is a pointer. */
    MemorySegment pointer(String function, Object... arguments) {
        return (MemorySegment) call(Optional.of(ValueLayout.ADDRESS), function, arguments);
    }

    private Object call(Optional<MemoryLayout> result, String function, Object... arguments) {
        MemorySegment address = library.find(function)
                .orElseThrow(() -> new DenoiseException("is not Open Image Denoise 2: it has no function " + function));
        try (Arena texts = Arena.ofConfined()) {
            List<MemoryLayout> layouts = new ArrayList<>();
            List<Object> values = new ArrayList<>();
            for (Object argument : arguments) {
                layouts.add(layout(argument));
                values.add(argument instanceof String text ? texts.allocateFrom(text) : argument);
            }
            MemoryLayout[] parameters = layouts.toArray(MemoryLayout[]::new);
            FunctionDescriptor type = result.map(layout -> FunctionDescriptor.of(layout, parameters))
                    .orElseGet(() -> FunctionDescriptor.ofVoid(parameters));
            return Linker.nativeLinker().downcallHandle(address, type).invokeWithArguments(values);
        } catch (RuntimeException | Error failure) {
            throw failure;
        } catch (Throwable failure) {
            throw new IllegalStateException(function, failure);
        }
    }

    private static MemoryLayout layout(Object argument) {
        return switch (argument) {
            case Boolean _ -> ValueLayout.JAVA_BOOLEAN;
            case Integer _ -> ValueLayout.JAVA_INT;
            case Long _ -> ValueLayout.JAVA_LONG;
            case Float _ -> ValueLayout.JAVA_FLOAT;
            default -> ValueLayout.ADDRESS;
        };
    }
}
