/**
 * Draws for the window, without a window: a thread of its own that owns the engine, takes the newest request, and hands
 * over the newest finished picture. Knows no JavaFX, so that all of it can be tested without a toolkit. Leans on the
 * engines, the scene, the sky, the world and the image package.
 */
package dev.twister.gui.drawing;
