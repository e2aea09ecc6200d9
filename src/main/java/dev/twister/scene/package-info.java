/**
 * What a scene file says: immutable records, the JSON reader and writer, and validation whose messages name the place.
 * Leans on {@code files} alone.
 */
package dev.twister.scene;
