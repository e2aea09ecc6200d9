/** Rendering pictures and films to files from the window. */
package dev.twister.gui.rendering;
