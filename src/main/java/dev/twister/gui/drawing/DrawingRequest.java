package dev.twister.gui.drawing;

import dev.twister.scene.Scene;

/**
 * What is to be drawn from now on.
 *
 * @param number counts the requests up; a picture tells which one it answers
 * @param scene what is seen; its settings' width and height do not count
 * @param width of the picture in pixels, 1 or more
 * @param height of the picture in pixels, 1 or more
 * @param engine what is to draw it
 * @param restful whether to draw one picture and wait for the next request, instead of one after the other
 */
public record DrawingRequest(long number, Scene scene, int width, int height, EngineChoice engine, boolean restful) {}
