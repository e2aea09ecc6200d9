package dev.twister.gui.drawing;

import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.world.Picture;

/**
 * What is to be drawn from now on.
 *
 * @param number counts the requests up; a picture tells which one it answers
 * @param document counts up with each scene that is opened; its edits have the same
 * @param scene what is seen; its settings' width and height do not count
 * @param width of the picture in pixels, 1 or more
 * @param height of the picture in pixels, 1 or more
 * @param engine what is to draw it
 * @param refineTo samples a pixel that the picture gathers while no other request comes, and then rests; 0 to draw the
 *     same picture again and again
 * @param motion whether and how bodies move
 * @param shown the picture, or a stage or a view of it
 */
public record DrawingRequest(
        long number,
        long document,
        Scene scene,
        int width,
        int height,
        EngineChoice engine,
        int refineTo,
        Motion motion,
        Picture shown) {
    /** A request for a picture of the first scene, its bodies where it has them. */
    public DrawingRequest(long number, Scene scene, int width, int height, EngineChoice engine, int refineTo) {
        this(number, 0, scene, width, height, engine, refineTo, Motion.NONE, Picture.REFLECTIONS);
    }

    /** Whether the other one asks for the same picture, of whatever engine. */
    boolean asksForThePictureOf(DrawingRequest other) {
        return equals(new DrawingRequest(
                number,
                other.document(),
                other.scene(),
                other.width(),
                other.height(),
                engine,
                refineTo,
                other.motion(),
                other.shown()));
    }

    /** Whether the other one asks for the same but for another exposure, tone map or sRGB curve. */
    boolean asksForAnotherToneOf(DrawingRequest other) {
        Rendering tone = scene.rendering();
        Scene toned = other.scene()
                .withRendering(other.scene().rendering().withTone(tone.exposure(), tone.toneMap(), tone.srgb()));
        return !scene.equals(other.scene())
                && equals(new DrawingRequest(
                        number,
                        other.document(),
                        toned,
                        other.width(),
                        other.height(),
                        other.engine(),
                        other.refineTo(),
                        other.motion(),
                        other.shown()));
    }

    /**
     * Whether a picture of the one is worth something to who waits for the other: the same place is seen, if from
     * elsewhere or its bodies moved, under the same sky and settings.
     */
    boolean showsThePlaceOf(DrawingRequest other) {
        return document == other.document()
                && shown == other.shown()
                && motion.start() == other.motion().start()
                && scene.sky().equals(other.scene().sky())
                && scene.rendering().equals(other.scene().rendering());
    }

    /** Whether one picture follows the other, though nothing is asked for. */
    public boolean isContinuous() {
        return refineTo == 0 || motion.running();
    }
}
