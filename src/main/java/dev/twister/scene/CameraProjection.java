package dev.twister.scene;

/** How the directions from a camera are laid out in its picture. */
public enum CameraProjection {
    /** As the eye and most lenses see: straight lines stay straight, what is far is small. */
    PERSPECTIVE,
    /** Without vanishing points: the same size at every distance. */
    ORTHOGRAPHIC,
    /**
     * The whole sphere of directions, as panoramas of skies have it; not distorted in pictures twice as wide as high.
     */
    PANORAMA,
    /** Equidistant: the angle from straight ahead grows evenly from the picture's middle on. */
    FISHEYE;

    /** The largest field of view in degrees. */
    public double maxFieldOfView() {
        return this == FISHEYE ? 360 : 179;
    }
}
