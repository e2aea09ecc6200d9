package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.mesh.MeshPose;
import dev.twister.scene.Rotation;
import dev.twister.scene.property.SceneLimits;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** What of a mesh file that is given instead of a scene is shown, and how it stands. */
public final class ModelOptions {
    private static final int ANGLES = 3;

    @Option(
            names = "--up",
            paramLabel = "AXIS",
            description = "For a mesh file: the axis that points up, y or z. Default: z for STL, else y.")
    private Optional<MeshPose.Up> up = Optional.empty();

    @Option(
            names = "--rotate",
            paramLabel = "DEGREES",
            split = ",",
            description = "For a mesh file: rotate it by YAW, or by YAW,PITCH,ROLL.")
    private List<Double> angles = List.of();

    @Option(
            names = "--scene",
            paramLabel = "NAME",
            description = "For a glTF file with several scenes: one of them, by its name or its number from 0. Default:"
                    + " the file's default scene.")
    private String scene = "";

    @Option(
            names = "--animation",
            paramLabel = "NAME",
            description = "For a glTF file with animations: the one to play, by its name or its number from 0; none for"
                    + " the mesh at rest. Default: the file's first.")
    private Optional<String> animation = Optional.empty();

    public boolean areGiven() {
        return up.isPresent() || !angles.isEmpty() || !scene.isEmpty() || animation.isPresent();
    }

    /** As in {@link dev.twister.scene.Geometry.OfFile}. */
    public String scene() {
        return scene;
    }

    /**
     * The pose of the mesh.
     *
     * @throws BadInputException if the number of angles is wrong, or one is out of range
     */
    public MeshPose pose() {
        if (!angles.isEmpty() && angles.size() != 1 && angles.size() != ANGLES) {
            throw new BadInputException(
                    "--rotate has " + angles.size() + " angles; give YAW, or YAW,PITCH,ROLL in degrees");
        }
        return new MeshPose(up, new Rotation(angle(0), angle(1), angle(2)), animation);
    }

    private double angle(int index) {
        double angle = index < angles.size() ? angles.get(index) : 0;
        return Ranges.check("--rotate", angle, SceneLimits.ANGLE);
    }
}
