/**
 * Edits of a scene in the window, without JavaFX: bodies by their {@link dev.twister.gui.edit.BodyNumber}, their tags,
 * materials and keyframes, several at once, and {@link dev.twister.gui.edit.SceneHistory what can be undone}.
 */
package dev.twister.gui.edit;
