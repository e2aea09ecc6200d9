/**
 * Between the picture and the scene, without JavaFX: what is under the pointer, where bodies and their handles are in
 * the picture, how a drag moves them, and where a new body finds a free place.
 */
package dev.twister.gui.picking;
