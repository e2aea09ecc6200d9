package dev.twister.scene.format;

import java.util.List;

/**
 * How an object stands in a scene file.
 *
 * @param <R> the record that it is read as
 */
sealed interface ObjectType<R> extends ValueType<R> permits Shaped, ValueType.Structure {
    /** All fields that it may have. */
    List<String> names();

    /**
     * Reads an object.
     *
     * @param alternatives fields that it does not have, and that would make it another object
     */
    R read(Place place, List<String> alternatives);
}
