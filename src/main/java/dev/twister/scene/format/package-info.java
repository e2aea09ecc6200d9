/**
 * Reads and writes scene files: the format's fields, JSON with places, and validation whose messages name the place.
 */
package dev.twister.scene.format;
