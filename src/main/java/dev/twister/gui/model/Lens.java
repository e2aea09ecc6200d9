package dev.twister.gui.model;

import dev.twister.scene.Camera;

/**
 * What of a camera belongs to the scene, wherever a person stands in it.
 *
 * @param aperture the radius in meters; with 0 all is sharp
 * @param focusDistance in meters
 */
public record Lens(double aperture, double focusDistance) {
    public static Lens of(Camera camera) {
        return new Lens(camera.aperture(), camera.focusDistance());
    }

    /** That camera with this lens. */
    public Camera on(Camera camera) {
        return camera.withAperture(aperture).withFocusDistance(focusDistance);
    }
}
