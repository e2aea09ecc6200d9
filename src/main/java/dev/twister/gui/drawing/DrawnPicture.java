package dev.twister.gui.drawing;

import dev.twister.gui.model.BodyNumber;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;

/**
 * A finished picture.
 *
 * @param frame 8-bit pixels; they stay as they are until the picture has been given back. Smaller than requested at the
 *     start, when nothing is compiled yet
 * @param request the request that it answers
 * @param input what the engine saw: where each body was
 * @param meshes those that it shows, where its scene has them
 * @param engine the id of the engine that drew it
 * @param device what did the work, for a person
 * @param times where its time went
 * @param samples a pixel, those of earlier pictures that it refines included
 * @param number counts the pictures up; every one that the engine drew counts, shown or not
 * @param original the number of the picture of which this one is a repetition, pixel by pixel; its own where it is none
 * @param finishedNanos when it was finished, by {@link System#nanoTime}
 */
public record DrawnPicture(
        Frame frame,
        DrawingRequest request,
        FrameInput input,
        SceneMeshes meshes,
        String engine,
        String device,
        FrameTimes times,
        int samples,
        long number,
        long original,
        long finishedNanos) {
    /** The same picture with its pixels in another frame, which has them too. */
    DrawnPicture in(Frame other) {
        return new DrawnPicture(
                other, request, input, meshes, engine, device, times, samples, number, original, finishedNanos);
    }

    /** The number that its scene's body has that is seen under a number of the input, see {@link BodyNumber}. */
    public int sceneBody(int body) {
        return BodyNumber.inScene(body, input, request.scene(), meshes);
    }

    /** Whether it has all the pixels that were asked for. */
    public boolean isWhole() {
        return frame.width() == request.width() && frame.height() == request.height();
    }
}
