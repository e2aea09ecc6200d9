/** Selecting and moving bodies in the picture. */
package dev.twister.gui.bodies;
