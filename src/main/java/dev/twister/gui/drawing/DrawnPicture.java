package dev.twister.gui.drawing;

import dev.twister.gui.edit.BodyNumber;
import dev.twister.image.Frame;
import dev.twister.image.FrameTimes;
import dev.twister.world.FrameInput;
import dev.twister.world.SceneMeshes;
import java.util.OptionalDouble;

/**
 * A finished picture.
 *
 * @param frame 8-bit pixels, valid until the picture is given back; smaller than requested just after the start, when
 *     nothing is compiled yet
 * @param request the request that it answers
 * @param input the engine's input, with the place of each body
 * @param meshes the meshes that it shows
 * @param engine id of the engine that drew it
 * @param device name of the device
 * @param times of the steps
 * @param gathered the samples
 * @param number counts the pictures that the engine drew, shown or not
 * @param original number of the picture that this one repeats pixel by pixel; its own if it repeats none
 * @param finishedNanos by {@link System#nanoTime}
 */
public record DrawnPicture(
        Frame frame,
        DrawingRequest request,
        FrameInput input,
        SceneMeshes meshes,
        String engine,
        String device,
        FrameTimes times,
        Gathered gathered,
        long number,
        long original,
        long finishedNanos) {
    /** A copy with another frame that has the same pixels. */
    DrawnPicture in(Frame other) {
        return new DrawnPicture(
                other, request, input, meshes, engine, device, times, gathered, number, original, finishedNanos);
    }

    /** Maps a body's number in the input to its number in the scene, see {@link BodyNumber}. */
    public int sceneBody(int body) {
        return BodyNumber.inScene(body, input, request.scene(), meshes);
    }

    /** Samples per pixel, including those of earlier pictures that it refines. */
    public int samples() {
        return gathered.samples();
    }

    /** Estimated standard error, relative to white; empty if it is unknown. */
    public OptionalDouble noise() {
        return gathered.noise();
    }

    /** Whether it has the requested size. */
    public boolean isWhole() {
        return frame.width() == request.width() && frame.height() == request.height();
    }

    /**
     * What a picture was made of.
     *
     * @param samples per pixel, including those of earlier pictures that it refines
     * @param noise estimated standard error of the samples, relative to white; empty if it is unknown
     * @param denoised whether the noise was removed
     * @param isDone whether no more samples are gathered for it
     */
    public record Gathered(int samples, OptionalDouble noise, boolean denoised, boolean isDone) {
        /** Samples of a picture that is not refined. */
        public static Gathered of(int samples) {
            return new Gathered(samples, OptionalDouble.empty(), false, false);
        }
    }
}
