package dev.twister.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MeshPoseTest {
    private static final String OBJ = "v -1 0 0\nv 1 0 0\nv 0 0 3\nf 1 2 3\n";
    private static final String STL = """
            solid a
            facet normal 0 0 1
            outer loop
            vertex -1 0 0
            vertex 1 0 0
            vertex 0 0 3
            endloop
            endfacet
            endsolid a
            """;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"a.obj, Z, 3", "a.obj, Y, 0", "a.obj, , 0", "a.stl, Z, 3", "a.stl, Y, 0", "a.stl, , 3"})
    void thatAxisPointsUp(String name, MeshPose.Up up, double height) {
        MeshFile file = Reading.read(folder, name, name.endsWith(".stl") ? STL : OBJ);
        MeshPose pose = new MeshPose(Optional.ofNullable(up), Rotation.NONE, Optional.empty());

        Box box = file.bounds(turn(pose.rotation(folder.resolve(name))));

        assertThat(box.largest().y() - box.least().y()).isCloseTo(height, within(1e-12));
        assertThat(box.largest().x()).isCloseTo(1, within(1e-12));
    }

    @Test
    void isRotatedAfterThat() {
        Path file = folder.resolve("a.obj");
        Reading.read(folder, "a.obj", OBJ);
        Rotation rotation = new Rotation(130, 20, -40);
        Vector3 point = new Vector3(0.3, -1.2, 0.7);

        Rotation whole = new MeshPose(Optional.of(MeshPose.Up.Z), rotation, Optional.empty()).rotation(file);

        Vector3 expected = turn(rotation).point(turn(new Rotation(0, 90, 0)).point(point));
        assertThat(turn(whole).point(point).minus(expected).length()).isLessThan(1e-12);
    }

    @ParameterizedTest
    @CsvSource({"10, 20, 30", "-89, 170, -170", "90, 45, 0", "-90, -120, 0", "0, 0, 180"})
    void anglesAreThoseOfTheRotation(double pitch, double yaw, double roll) {
        Rotation angles = MeshPlacement.angles(turn(new Rotation(yaw, pitch, roll)));

        assertThat(angles.yawDegrees()).isCloseTo(yaw, within(1e-6));
        assertThat(angles.pitchDegrees()).isCloseTo(pitch, within(1e-6));
        assertThat(angles.rollDegrees()).isCloseTo(roll, within(1e-6));
    }

    private static Affine turn(Rotation rotation) {
        return MeshPlacement.of(Mesh.of(Path.of("a")).withRotation(rotation));
    }
}
