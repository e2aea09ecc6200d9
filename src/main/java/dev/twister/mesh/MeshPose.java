package dev.twister.mesh;

import dev.twister.mesh.input.QuotedText;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Rotation;
import dev.twister.scene.property.SceneLimits;
import java.nio.file.Path;
import java.util.Optional;

/**
 * How a mesh stands, before anything is said of its place.
 *
 * @param up the axis of the file that points up; empty for the one of its format
 * @param rotation applied then
 * @param animation the animation's name or number, or {@link #AT_REST}; empty for the file's first
 */
public record MeshPose(Optional<Up> up, Rotation rotation, Optional<String> animation) {
    /** As the file has it. */
    public static final MeshPose OF_FILE = new MeshPose(Optional.empty(), Rotation.NONE, Optional.empty());

    /** In place of an animation's name. */
    public static final String AT_REST = "none";

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

    /**
     * The animation that the mesh plays.
     *
     * @throws MeshException if the file has none of that name
     */
    MeshAnimation animation(Path file, MeshFile held) {
        int clips = held.rig().clips().size();
        if (animation.isPresent() ? animation.get().equals(AT_REST) : clips == 0) {
            return MeshAnimation.NONE;
        }
        if (animation.isEmpty()) {
            String first = held.rig().clips().getFirst().name();
            return MeshAnimation.of(isName(first) ? first : "0");
        }
        held.complaint(animation.get()).ifPresent(problem -> {
            throw new MeshException(QuotedText.path(file) + ": " + problem + ", or none");
        });
        return MeshAnimation.of(animation.get());
    }

    /** Whether a scene file can have it. */
    private static boolean isName(String name) {
        return !name.isEmpty()
                && name.length() <= SceneLimits.MAX_NAME_LENGTH
                && name.codePoints().noneMatch(Character::isISOControl);
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
