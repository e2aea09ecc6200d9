package dev.twister.gui.edit;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraKeyframe;
import java.util.List;

/**
 * The part of a camera that does not depend on the view: its projection, its lens and its keyframes.
 *
 * @param aperture the lens's radius in meters; 0 for a pinhole, which is sharp everywhere
 * @param focusDistance in meters
 * @param keyframes of a film, each later than the one before
 */
public record CameraRig(
        Camera.Projection projection, double aperture, double focusDistance, List<CameraKeyframe> keyframes) {
    public static CameraRig of(Camera camera) {
        return new CameraRig(camera.projection(), camera.aperture(), camera.focusDistance(), camera.keyframes());
    }

    /** That camera with this projection, lens and keyframes. */
    public Camera on(Camera camera) {
        return camera.withProjection(projection)
                .withAperture(aperture)
                .withFocusDistance(focusDistance)
                .withKeyframes(keyframes);
    }

    /** What the edit from the one to the other makes of this one: what it leaves as it was stays. */
    CameraRig edited(CameraRig from, CameraRig to) {
        return new CameraRig(
                from.projection == to.projection ? projection : to.projection,
                from.aperture == to.aperture ? aperture : to.aperture,
                from.focusDistance == to.focusDistance ? focusDistance : to.focusDistance,
                from.keyframes.equals(to.keyframes) ? keyframes : to.keyframes);
    }
}
