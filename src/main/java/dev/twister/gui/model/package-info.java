/**
 * The window's logic without a window: the undo history, picking and dragging, progressive refinement, recording, and
 * settings kept between runs. Uses the rendering packages, never JavaFX, so that all of it can be tested without a
 * display.
 */
package dev.twister.gui.model;
