/**
 * Rendering to files: an order says what to render, and one class carries it out, for the commands and the window:
 * pictures, numbered frames and films. Depends on the scene, its world, physics and motion files, engines, image and
 * film, and the background writer of {@code threads}.
 */
package dev.twister.render;
