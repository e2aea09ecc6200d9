package dev.twister.world;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Reads the components of records of any kind. For use by one thread. */
public final class RecordParts {
    private final Map<Class<?>, RecordComponent[]> componentsByRecord = new HashMap<>();

    /** The values of a record's components, in their order. */
    public List<Object> of(Record record) {
        List<Object> parts = new ArrayList<>();
        for (RecordComponent component :
                componentsByRecord.computeIfAbsent(record.getClass(), Class::getRecordComponents)) {
            try {
                parts.add(component.getAccessor().invoke(record));
            } catch (IllegalAccessException | InvocationTargetException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
        return parts;
    }
}
