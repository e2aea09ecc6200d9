package dev.twister.scene;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;
import dev.twister.scene.property.SceneProperties;

/**
 * How a picture is made; a scene file gives the defaults, a command line or a panel overrides them.
 *
 * @param width in pixels, 1 to {@value #MAX_SIDE}
 * @param height in pixels, 1 to {@value #MAX_SIDE}
 * @param shadowSamples points on the light's disc, 1 to {@value #MAX_SHADOW_SAMPLES}; 1 is a hard shadow
 * @param bounces limit of reflections, in path tracing the number of surfaces after the first one; 0 to
 *     {@value #MAX_BOUNCES}
 * @param samplesPerPixel view rays a pixel, 1 to {@value #MAX_SAMPLES_PER_PIXEL}
 * @param exposure in stops, -20 to 20: linear color is multiplied by 2^exposure
 * @param toneMap applied after the exposure
 * @param srgb whether the sRGB curve is applied after the tone map
 * @param integrator how light is followed
 * @param clamp for path tracing: limit of the luminance of light that reaches the eye over more than one surface; 0 for
 *     none
 * @param shutter how long the shutter is open before a frame's time, as a fraction of a frame, 0 to 1; 0 for no motion
 *     blur
 */
@Copied
public record Rendering(
        int width,
        int height,
        int shadowSamples,
        int bounces,
        int samplesPerPixel,
        double exposure,
        ToneMap toneMap,
        boolean srgb,
        Integrator integrator,
        double clamp,
        double shutter)
        implements RenderingCopy.With {
    public static final int MAX_SIDE = 16384;
    public static final int MAX_SHADOW_SAMPLES = 1024;
    public static final int MAX_BOUNCES = 64;
    public static final int MAX_SAMPLES_PER_PIXEL = 65536;
    public static final double MAX_EXPOSURE_STOPS = 20;
    public static final double DEFAULT_CLAMP = 10;

    /**
     * 1280 x 720, 200 shadow samples and 3 bounces as in the paper, clamped, with the sRGB curve, without motion blur.
     */
    public static final Rendering DEFAULT =
            new Rendering(1280, 720, 200, 3, 1, 0, ToneMap.CLAMP, true, Integrator.WHITTED, DEFAULT_CLAMP, 0);

    public Rendering {
        requireNonNull(toneMap, "toneMap");
        requireNonNull(integrator, "integrator");
    }

    /**
     * Checks all values.
     *
     * @throws SceneException if a value is out of range; the message names it
     */
    public void requireInRange() {
        SceneProperties.RENDERING.forEach(property -> property.requireInRange("rendering", this));
    }

    public Rendering withSize(int newWidth, int newHeight) {
        return withWidth(newWidth).withHeight(newHeight);
    }

    public Rendering withTone(double newExposure, ToneMap newToneMap, boolean newSrgb) {
        return withExposure(newExposure).withToneMap(newToneMap).withSrgb(newSrgb);
    }
}
