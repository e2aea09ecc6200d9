package dev.twister.mesh;

import dev.twister.scene.Geometry;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Shape;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;

/** The placement of a mesh in a scene. */
public final class MeshPlacement {
    /** Sine of a pitch at which yaw and roll turn about the same axis. */
    private static final double STEEP = 1 - 1e-12;

    private MeshPlacement() {}

    /**
     * The transform from the coordinates of the file, or of the shape's basis, to the scene's: scale, then roll about z
     * (positive from x to y), pitch, yaw, translation.
     */
    public static Affine of(Mesh mesh) {
        double pitch = Math.toRadians(mesh.rotation().pitchDegrees());
        double yaw = Math.toRadians(mesh.rotation().yawDegrees());
        double roll = Math.toRadians(mesh.rotation().rollDegrees());
        Affine rolled = new Affine(
                new Vector3(Math.cos(roll), Math.sin(roll), 0),
                new Vector3(-Math.sin(roll), Math.cos(roll), 0),
                new Vector3(0, 0, 1),
                Vector3.ZERO);
        Affine pitched = new Affine(
                new Vector3(1, 0, 0),
                new Vector3(0, Math.cos(pitch), Math.sin(pitch)),
                new Vector3(0, -Math.sin(pitch), Math.cos(pitch)),
                Vector3.ZERO);
        Affine turned = new Affine(
                new Vector3(Math.cos(yaw), 0, -Math.sin(yaw)),
                new Vector3(0, 1, 0),
                new Vector3(Math.sin(yaw), 0, Math.cos(yaw)),
                mesh.position());
        Vector3 stretch = stretch(mesh);
        Affine scaled = new Affine(
                new Vector3(stretch.x(), 0, 0),
                new Vector3(0, stretch.y(), 0),
                new Vector3(0, 0, stretch.z()),
                Vector3.ZERO);
        return turned.of(pitched).of(rolled).of(scaled);
    }

    /**
     * The angles of a rotation.
     *
     * @param turn a rotation about the origin
     */
    public static Rotation angles(Affine turn) {
        double sine = Math.clamp(-turn.axisZ().y(), -1, 1);
        boolean upright = Math.abs(sine) < STEEP;
        double yaw = upright
                ? Math.atan2(turn.axisZ().x(), turn.axisZ().z())
                : Math.atan2(-turn.axisX().z(), turn.axisX().x());
        double roll = upright ? Math.atan2(turn.axisX().y(), turn.axisY().y()) : 0;
        return new Rotation(Math.toDegrees(yaw), Math.toDegrees(Math.asin(sine)), Math.toDegrees(roll));
    }

    private static Vector3 stretch(Mesh mesh) {
        return switch (mesh.geometry()) {
            case Geometry.OfFile _, Triangles _ -> new Vector3(mesh.scale(), mesh.scale(), mesh.scale());
            case Shape shape -> shape.stretch().times(mesh.scale());
        };
    }
}
