package dev.twister.oracle;

import dev.twister.scene.Camera;

/** Creates view rays through positions in the picture. */
final class OracleCamera {
    private final int width;
    private final int height;
    private final Vector position;
    private final Vector right;
    private final Vector up;
    private final Vector forward;
    private final double eyeDistance;
    private final Camera.Projection projection;
    private final double viewHeight;
    private final double halfField;
    private final double aperture;
    private final double focusDistance;

    /**
     * The rotated axes and the eye's distance are rounded to floats, as for engines: rotating each direction in double
     * precision instead would deviate by up to 6e-8 radians, which shows at edges with a field of view of 1 degree.
     */
    OracleCamera(Camera camera, int width, int height) {
        this.width = width;
        this.height = height;
        position = new Vector(
                camera.position().x(), camera.position().y(), camera.position().z());
        double yaw = Math.toRadians(camera.yawDegrees());
        double pitch = Math.toRadians(camera.pitchDegrees());
        right = rounded(turnedRight(turnedDown(new Vector(1, 0, 0), pitch), yaw));
        up = rounded(turnedRight(turnedDown(new Vector(0, 1, 0), pitch), yaw));
        forward = rounded(turnedRight(turnedDown(new Vector(0, 0, 1), pitch), yaw));
        eyeDistance = (float) (1 / Math.tan(Math.toRadians(camera.fieldOfViewDegrees()) / 2));
        projection = camera.projection();
        viewHeight = camera.viewHeight();
        halfField = Math.toRadians(camera.fieldOfViewDegrees()) / 2;
        boolean flat = projection == Camera.Projection.PERSPECTIVE || projection == Camera.Projection.ORTHOGRAPHIC;
        aperture = flat ? camera.aperture() : 0;
        focusDistance = camera.focusDistance();
    }

    /**
     * Returns the ray through (x, y) in pixels from the top left corner: from the sampled point of the lens to where
     * the pinhole ray hits the plane at the focus distance.
     */
    ViewRay ray(double x, double y, SampleNumbers numbers) {
        double u = width > height ? (x - width / 2.0 + height / 2.0) / height * 2 - 1 : x / width * 2 - 1;
        double v = width > height ? -(y / height * 2 - 1) : -((y - height / 2.0 + width / 2.0) / width * 2 - 1);
        Vector direction = direction(x, y, u, v).normalized();
        Vector position = projection == Camera.Projection.ORTHOGRAPHIC ? parallel(x, y) : this.position;
        if (aperture == 0) {
            return new ViewRay(new Ray(position, direction), numbers);
        }
        double radius = aperture * Math.sqrt(numbers.lensRadius());
        double angle = 2 * Math.PI * numbers.lensTurns();
        Vector start = position.plus(right.times(radius * Math.cos(angle))).plus(up.times(radius * Math.sin(angle)));
        Vector focus = position.plus(direction.times(focusDistance / direction.dot(forward)));
        return new ViewRay(new Ray(start, focus.minus(start).normalized()), numbers);
    }

    private Vector direction(double x, double y, double u, double v) {
        return switch (projection) {
            case PERSPECTIVE -> along(u, v, eyeDistance);
            case ORTHOGRAPHIC -> forward;
            case PANORAMA -> {
                double turn = (x / width - 0.5) * 2 * Math.PI;
                double height = (0.5 - y / this.height) * Math.PI;
                yield along(Math.sin(turn) * Math.cos(height), Math.sin(height), Math.cos(turn) * Math.cos(height));
            }
            case FISHEYE -> {
                double away = Math.hypot(u, v);
                double angle = Math.min(Math.PI, away * halfField);
                double across = away == 0 ? 0 : Math.sin(angle) / away;
                yield along(across * u, across * v, Math.cos(angle));
            }
        };
    }

    private Vector along(double toRight, double toUp, double ahead) {
        return right.times(toRight).plus(up.times(toUp)).plus(forward.times(ahead));
    }

    private Vector parallel(double x, double y) {
        double meters = viewHeight / height;
        return position.plus(along((x - width / 2.0) * meters, (height / 2.0 - y) * meters, 0));
    }

    /** Rotates about x, from forward to down. */
    private static Vector turnedDown(Vector vector, double pitch) {
        return new Vector(
                vector.x(),
                vector.y() * Math.cos(pitch) - vector.z() * Math.sin(pitch),
                vector.y() * Math.sin(pitch) + vector.z() * Math.cos(pitch));
    }

    /** Rotates about y, from forward to right. */
    private static Vector turnedRight(Vector vector, double yaw) {
        return new Vector(
                vector.x() * Math.cos(yaw) + vector.z() * Math.sin(yaw),
                vector.y(),
                -vector.x() * Math.sin(yaw) + vector.z() * Math.cos(yaw));
    }

    private static Vector rounded(Vector vector) {
        return new Vector((float) vector.x(), (float) vector.y(), (float) vector.z());
    }
}
