package dev.twister.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import dev.twister.physics.Simulation;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Shape;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.Vector3;
import dev.twister.scene.format.SceneReader;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MotionFileTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes", "teaching.json"));
    private static final int BODIES = 2 + SCENE.spheres().size();

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void nameTheFile() {
        file = folder.resolve("shot.motion");
    }

    @Test
    void framesComeBackByTheirNumbers() throws IOException {
        record(7, 3);

        try (MotionFile motion = MotionFile.open(file, SCENE)) {
            assertThat(motion.firstFrame()).isEqualTo(7);
            assertThat(motion.lastFrame()).isEqualTo(9);
            assertThat(motion.rate()).isEqualTo(24);
            assertThat(motion.frame(8).present()).isEqualTo(BODIES);
            assertThat(motion.frame(8).positions()).isEqualTo(positions(8));
        }
    }

    @Test
    void goesOnBehindWhatIsWholeWhereverItWasCut() throws IOException {
        record(0, 3);
        byte[] whole = Files.readAllBytes(file);

        for (int length = 0; length < whole.length; length += 13) {
            Files.write(file, whole);
            cut(length);
            int frames = record(0, 3);

            assertThat(frames).isEqualTo(Math.max(0, length - MotionHeader.BYTES) / MotionFrame.bytes(BODIES));
            assertThat(file).hasBinaryContent(whole);
        }
    }

    @Test
    void aFrameThatIsDamagedAtTheEndIsWrittenAnew() throws IOException {
        record(0, 3);
        byte[] whole = Files.readAllBytes(file);
        try (RandomAccessFile bytes = new RandomAccessFile(file.toFile(), "rw")) {
            bytes.seek(whole.length - 20);
            bytes.write(new byte[20]);
        }

        assertThat(record(0, 3)).isEqualTo(2);
        assertThat(file).hasBinaryContent(whole);
    }

    @Test
    void aFrameThatIsNotThereIsToldWithTheLastOne() throws IOException {
        record(5, 3);
        cut(Files.size(file) - 1);

        try (MotionFile motion = MotionFile.open(file, SCENE)) {
            assertThatIOException()
                    .isThrownBy(() -> motion.frame(7))
                    .withMessageStartingWith(file + " ends with frame 6, but frame 7 is wanted");
            assertThatIOException()
                    .isThrownBy(() -> motion.frame(4))
                    .withMessageStartingWith(file + " begins with frame 5, but frame 4 is wanted");
        }
    }

    @Test
    void refusesTheMotionOfAnotherScene() throws IOException {
        record(0, 1);
        Scene other = SCENE.withPhysics(SCENE.physics().withGravity(new Vector3(0, -1, 0)));

        assertThatIOException()
                .isThrownBy(() -> MotionFile.open(file, other))
                .withMessageStartingWith(file + " has the motion of another scene");
        assertThatIOException().isThrownBy(() -> MotionRecording.open(file, other, 0, 24));
    }

    @Test
    void takesTheSceneWithAnotherCameraAndLight() throws IOException {
        record(0, 1);
        Scene edited = SCENE.withCamera(SCENE.camera().withYawDegrees(50)).withShading(new Shading(0.9));

        try (MotionFile motion = MotionFile.open(file, edited)) {
            assertThat(motion.lastFrame()).isZero();
        }
    }

    @Test
    void tracksThatMoveMeshesAreOfTheMotion() throws IOException {
        record(0, 1);
        Scene with = SCENE.withMeshes(List.of(Mesh.of(Shape.of(Shape.Kind.BOX, 1))));
        Track ofSphere = Track.of(TrackTarget.sphere(0), "position", Keyframe.of(0, Vector3.ZERO));
        Track color = Track.of(TrackTarget.mesh(0), "color", Keyframe.of(0, new Vector3(1, 0, 0)));
        Track turn = Track.of(TrackTarget.mesh(0), "rotation", Keyframe.of(0, new Vector3(9, 0, 0)));

        try (MotionFile motion = MotionFile.open(file, SCENE.withTracks(List.of(ofSphere)))) {
            assertThat(motion.lastFrame()).isZero();
        }
        assertThat(MotionDigest.of(with.withTracks(List.of(color)))).isEqualTo(MotionDigest.of(with));
        assertThat(MotionDigest.of(with.withTracks(List.of(turn)))).isNotEqualTo(MotionDigest.of(with));
    }

    @Test
    void refusesForeignFilesAndLeavesThemAsTheyAre() throws IOException {
        for (String content : new String[] {"short", "x".repeat(500)}) {
            Files.writeString(file, content);

            assertThatIOException()
                    .isThrownBy(() -> MotionFile.open(file, SCENE))
                    .withMessageContaining("not a motion file");
            assertThatIOException()
                    .isThrownBy(() -> MotionRecording.open(file, SCENE, 0, 24))
                    .withMessageContaining("not a motion file");
            assertThat(file).hasContent(content);
        }
    }

    @Test
    void isWrittenByOneAtATime() throws IOException {
        try (MotionRecording recording = MotionRecording.open(file, SCENE, 0, 24)) {
            assertThat(recording.nextFrame()).isZero();
            assertThatIOException()
                    .isThrownBy(() -> MotionRecording.open(file, SCENE, 0, 24))
                    .withMessage(file + " is being written by another process");
        }
    }

    @Test
    void aSecondTakeMustBeTheSame() throws IOException {
        record(0, 2);

        try (MotionRecording recording = MotionRecording.open(file, SCENE, 0, 24)) {
            assertThatIOException()
                    .isThrownBy(() -> recording.put(1, new MotionFrame(BODIES, new float[3 * BODIES])))
                    .withMessageContaining("frame 1 is not what this version of Twister simulates");
        }
    }

    @Test
    void pointCachesHaveTheSpheresInTheScenesCoordinates() throws IOException {
        record(4, 2);
        Path cache = folder.resolve("shot.pc2");
        try (MotionFile motion = MotionFile.open(file, SCENE)) {
            PointCache.write(cache, motion, 4, 5);
        }

        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(cache)).order(ByteOrder.LITTLE_ENDIAN);
        byte[] magic = new byte[12];
        bytes.get(magic);
        assertThat(magic).isEqualTo(new byte[] {'P', 'O', 'I', 'N', 'T', 'C', 'A', 'C', 'H', 'E', '2', 0});
        assertThat(bytes.getInt()).isEqualTo(1);
        assertThat(bytes.getInt()).isEqualTo(BODIES - 2);
        assertThat(bytes.getFloat()).isEqualTo(4);
        assertThat(bytes.getFloat()).isEqualTo(1);
        assertThat(bytes.getInt()).isEqualTo(2);
        assertThat(bytes.remaining()).isEqualTo(2 * 12 * (BODIES - 2));
        assertThat(bytes.getFloat()).isEqualTo(positions(4)[6]);
    }

    private void cut(long length) throws IOException {
        try (RandomAccessFile bytes = new RandomAccessFile(file.toFile(), "rw")) {
            bytes.setLength(length);
        }
    }

    /** Returns the number of frames that the file already held. */
    private int record(int first, int count) throws IOException {
        try (MotionRecording recording = MotionRecording.open(file, SCENE, first, 24)) {
            int there = recording.nextFrame() - first;
            for (int number = recording.nextFrame(); number < first + count; number++) {
                recording.put(number, new MotionFrame(BODIES, positions(number)));
            }
            return there;
        }
    }

    private static float[] positions(int frame) {
        try (Simulation simulation = Simulation.of(SCENE, SceneMeshes.NONE, 1)) {
            simulation.advance(frame / 24.0);
            return simulation.positions();
        }
    }
}
