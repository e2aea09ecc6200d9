package dev.twister.scene.format.json;

/** A value's place in a document, written as {@code $.spheres[3].radius}. */
public sealed interface JsonPath {
    /** The whole document. */
    record Root() implements JsonPath {
        @Override
        public String toString() {
            return "$";
        }
    }

    /** A field of an object. */
    record Field(JsonPath parent, String name) implements JsonPath {
        @Override
        public String toString() {
            return parent + "." + Excerpt.shortened(name);
        }
    }

    /** An item of an array, from 0. */
    record Item(JsonPath parent, int index) implements JsonPath {
        @Override
        public String toString() {
            return parent + "[" + index + "]";
        }
    }
}
