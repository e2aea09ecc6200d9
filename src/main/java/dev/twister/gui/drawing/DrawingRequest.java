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
 * @param refineTo samples a pixel that the picture gathers while no other request comes, and then rests; 0 to draw the same
 *     picture again and again
 * @param motion whether and how bodies move
 */
public record DrawingRequest(
        long number, Scene scene, int width, int height, EngineChoice engine, int refineTo, Motion motion) {
    /** A request for a picture of bodies that stand where the scene has them. */
    public DrawingRequest(long number, Scene scene, int width, int height, EngineChoice engine, int refineTo) {
        this(number, scene, width, height, engine, refineTo, Motion.NONE);
    }

    /** Whether the other one asks for the same picture, of whatever engine. */
    boolean asksForThePictureOf(DrawingRequest other) {
        return equals(new DrawingRequest(
                number, other.scene(), other.width(), other.height(), engine, refineTo, other.motion()));
    }

    /** Whether one picture follows the other, though nothing is asked for. */
    public boolean isContinuous() {
        return refineTo == 0 || motion.running();
    }
}
