package dev.twister.lanes;

import java.util.LinkedHashMap;
import java.util.Map;

/** A call of a method while it is read: its local variables and what it returns. */
final class Activation {
    final Sources.Method method;

    /** Whether each local variable is a float. */
    final Map<String, Boolean> floats = new LinkedHashMap<>();

    Map<String, Value> values = new LinkedHashMap<>();

    /** What it returns; null before the end, and where it returns nothing. */
    Value returned;

    Activation(Sources.Method method) {
        this.method = method;
    }

    Value value(String name) {
        return values.get(name);
    }
}
