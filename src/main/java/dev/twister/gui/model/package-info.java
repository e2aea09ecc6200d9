/**
 * What the window shows and does, without a window: the history of edits, picking and dragging, the picture that
 * refines itself, recording, and what is kept between runs. Leans on the packages that draw, never on JavaFX, so that a
 * test reaches all of it.
 */
package dev.twister.gui.model;
