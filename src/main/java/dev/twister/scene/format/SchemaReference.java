package dev.twister.scene.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** The schema that a scene's file names for editors; no part of the scene. */
final class SchemaReference {
    static final String FIELD = "$schema";

    private SchemaReference() {}

    /** What a file says; empty where there is none, or no such file. Reads no further than that. */
    static Optional<String> of(Path file) {
        if (!Files.isRegularFile(file)) {
            return Optional.empty();
        }
        try (InputStream in = Files.newInputStream(file);
                JsonParser parser = new JsonFactory().createParser(ObjectReadContext.empty(), in)) {
            return find(parser);
        } catch (IOException | JacksonException _) {
            return Optional.empty();
        }
    }

    private static Optional<String> find(JsonParser parser) {
        if (parser.nextToken() != JsonToken.START_OBJECT) {
            return Optional.empty();
        }
        Optional<String> found = Optional.empty();
        while (found.isEmpty() && parser.nextToken() == JsonToken.PROPERTY_NAME) {
            boolean schema = FIELD.equals(parser.currentName());
            JsonToken value = parser.nextToken();
            if (schema && value == JsonToken.VALUE_STRING) {
                found = Optional.of(parser.getString());
            } else {
                parser.skipChildren();
            }
        }
        return found;
    }
}
