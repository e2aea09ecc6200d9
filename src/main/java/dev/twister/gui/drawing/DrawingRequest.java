package dev.twister.gui.drawing;

import dev.twister.denoise.DenoiserOffer;
import dev.twister.engine.EngineOffer;
import dev.twister.scene.Camera;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.world.StageOrView;
import java.util.Optional;

/**
 * What to draw.
 *
 * @param number counts requests; each picture names the request that it answers
 * @param document counts the scenes that were opened; the edits of one scene keep its number
 * @param scene drawn with its own settings except width and height
 * @param width in pixels, at least 1
 * @param height in pixels, at least 1
 * @param engine draws it
 * @param refinement how the picture gets better while nothing changes
 * @param motion whether and how bodies move
 * @param shown the picture, a stage or a view
 */
public record DrawingRequest(
        long number,
        long document,
        Scene scene,
        int width,
        int height,
        EngineChoice engine,
        Refinement refinement,
        Motion motion,
        StageOrView shown) {
    /** A request of the first document, without motion. */
    public DrawingRequest(long number, Scene scene, int width, int height, EngineChoice engine, int refineTo) {
        this(number, 0, scene, width, height, engine, Refinement.to(refineTo), Motion.NONE, StageOrView.BEAUTY);
    }

    /** Whether the other request has the same picture, on any engine. */
    boolean asksForThePictureOf(DrawingRequest other) {
        return equals(new DrawingRequest(
                number,
                other.document(),
                other.scene(),
                other.width(),
                other.height(),
                engine,
                refinement,
                other.motion(),
                other.shown()));
    }

    /**
     * Whether the other request's samples are those of this one: only exposure, tone map, sRGB curve, the noise at
     * which the picture rests or its denoising differ.
     */
    boolean asksForTheSamplesOf(DrawingRequest other) {
        Rendering tone = scene.rendering();
        Scene toned = other.scene()
                .withRendering(other.scene().rendering().withTone(tone.exposure(), tone.toneMap(), tone.srgb()));
        boolean refinesAlike = refinement.equals(other.refinement());
        return !(scene.equals(other.scene()) && refinesAlike)
                && refinement.samples() == other.refinement().samples()
                && equals(new DrawingRequest(
                        number,
                        other.document(),
                        toned,
                        other.width(),
                        other.height(),
                        other.engine(),
                        refinement,
                        other.motion(),
                        other.shown()));
    }

    /** Whether the other request differs only in the camera's place and direction. */
    boolean looksFromElsewhereThan(DrawingRequest other) {
        Camera here = scene.camera();
        Camera there = other.scene().camera();
        Camera moved = there.withPosition(here.position())
                .withYawDegrees(here.yawDegrees())
                .withPitchDegrees(here.pitchDegrees());
        return !here.equals(there)
                && equals(new DrawingRequest(
                        number,
                        other.document(),
                        other.scene().withCamera(moved),
                        other.width(),
                        other.height(),
                        other.engine(),
                        other.refinement(),
                        other.motion(),
                        other.shown()));
    }

    /**
     * Whether a picture of one request is useful to who waits for the other: the same place under the same sky and
     * settings, though from another camera or with bodies moved.
     */
    boolean showsThePlaceOf(DrawingRequest other) {
        return document == other.document()
                && shown == other.shown()
                && motion.start() == other.motion().start()
                && scene.sky().equals(other.scene().sky())
                && scene.rendering().equals(other.scene().rendering());
    }

    /** Whether pictures are drawn without end although nothing is requested. */
    public boolean isContinuous() {
        return refinement.samples() == 0 || motion.running();
    }

    /**
     * A choice of an engine. An engine that failed is tried again only when it is chosen again, which makes a new
     * choice.
     *
     * @param number counts the choices
     */
    public record EngineChoice(long number, EngineOffer offer) {}

    /**
     * How a picture at rest gets better.
     *
     * @param samples per pixel to gather before the picture rests; 0 to draw it again and again
     * @param noise at which a path-traced picture rests earlier, relative to white; 0 for none
     * @param denoiser removes the noise of a path-traced picture; empty to leave it
     */
    public record Refinement(int samples, double noise, Optional<DenoiserOffer> denoiser) {
        /** To a number of samples alone. */
        public static Refinement to(int samples) {
            return new Refinement(samples, 0, Optional.empty());
        }
    }

    /**
     * Whether and how bodies move.
     *
     * @param start the number of the start; a new number restarts the bodies from their places in the scene; 0 for no
     *     motion
     * @param running whether time passes
     * @param steps number of single steps since the start
     */
    public record Motion(long start, boolean running, long steps) {
        /** No motion. */
        public static final Motion NONE = new Motion(0, false, 0);

        /** Whether physics places the bodies. */
        public boolean isOn() {
            return start != 0;
        }
    }
}
