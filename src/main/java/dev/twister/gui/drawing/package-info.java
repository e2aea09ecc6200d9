/**
 * Draws for the window, without a window: a thread of its own that owns the engine, takes the newest request, and hands
 * over the newest finished picture. Knows no JavaFX, so that all of it can be tested without a toolkit. Leans on the
 * engines and what {@code bench} knows of the fastest, the scene, the sky, the world, the physics, the image package,
 * and {@code gui.model}.
 */
package dev.twister.gui.drawing;
