/**
 * Draws for the window: a thread that owns the engine, takes the newest request, and hands over the newest finished
 * picture. Uses no JavaFX, so that tests need no toolkit.
 */
package dev.twister.gui.drawing;
