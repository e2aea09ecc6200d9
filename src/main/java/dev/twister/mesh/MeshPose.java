package dev.twister.mesh;

import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import java.nio.file.Path;
import java.util.Optional;

/**
 * How a mesh stands, before anything is said of its place.
 *
 * @param up the axis of the file that points up; empty for the one of its format
 * @param rotation applied then
 */
public record MeshPose(Optional<Up> up, Rotation rotation) {
    /** As the file has it. */
    public static final MeshPose OF_FILE = new MeshPose(Optional.empty(), Rotation.NONE);

    private static final double QUARTER_TURN = 90;

    /** An axis of a file. */
    public enum Up {
        Y,
        Z
    }

    /** The rotation of the mesh in a scene, as {@link Mesh#rotation}. */
    Rotation rotation(Path file) {
        double pitch = up.map(axis -> pitch(axis, MeshReader.hasZUp(file))).orElse(0.0);
        if (pitch == 0) {
            return rotation;
        }
        return MeshPlacement.angles(turn(file, rotation).of(turn(file, Rotation.NONE.withPitchDegrees(pitch))));
    }

    private static double pitch(Up wanted, boolean zUp) {
        double toY = zUp ? -QUARTER_TURN : 0;
        double toZ = zUp ? 0 : QUARTER_TURN;
        return wanted == Up.Z ? toZ : toY;
    }

    private static Affine turn(Path file, Rotation angles) {
        return MeshPlacement.of(Mesh.of(file).withRotation(angles));
    }
}
