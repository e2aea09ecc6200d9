package dev.twister.motion;

import dev.twister.scene.Camera;
import dev.twister.scene.CameraView;
import dev.twister.scene.Geometry;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.Shading;
import dev.twister.scene.Sky;
import dev.twister.scene.Track;
import dev.twister.scene.TrackTarget;
import dev.twister.scene.generate.Palette;
import dev.twister.scene.property.MaterialProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.select.Title;
import dev.twister.world.RecordParts;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** A digest of everything in a scene that affects the motion of its bodies: all of it but what is only seen. */
final class MotionDigest {
    static final int BYTES = 32;

    private static final Set<Class<?>> ONLY_SEEN = Set.of(
            Title.class,
            Camera.class,
            CameraView.class,
            Material.class,
            Rgb.class,
            Palette.class,
            Sky.class,
            Shading.class,
            Rendering.class);

    private final MessageDigest digest = sha256();
    private final RecordParts parts = new RecordParts();

    private MotionDigest() {}

    /** SHA-256 of the data that the motion depends on. */
    static byte[] of(Scene scene) {
        MotionDigest motion = new MotionDigest();
        motion.add(scene);
        return motion.digest.digest();
    }

    private void add(Object part) {
        if (ONLY_SEEN.contains(part.getClass())) {
            return;
        }
        switch (part) {
            case Light light -> {
                addText(Light.class.getSimpleName());
                add(light.position());
                add(light.radius());
            }
            case Mesh mesh when mesh.smoothDegrees() != 0 -> add(mesh.withSmoothDegrees(0));
            // Digests of scenes with files at rest alone stay the same.
            case Geometry.OfFile(Path path, String chosen) when chosen.isEmpty() -> add(path);
            // Physics moves spheres whatever their tracks say, but meshes move by theirs.
            case Track track when !movesMesh(track) -> {}
            case MeshAnimation animation when animation.isNone() -> {}
            case Record record -> {
                addText(record.getClass().getSimpleName());
                parts.of(record).forEach(this::add);
            }
            case Collection<?> items -> items.forEach(this::add);
            case Map<?, ?> named -> named.values().forEach(this::add);
            case Optional<?> some -> some.ifPresent(this::add);
            // Only the file's name: the folder may differ between the machines of a farm.
            case Path file -> addText(file.getFileName());
            // The text of numbers is exact.
            default -> addText(part);
        }
    }

    private static boolean movesMesh(Track track) {
        return track.target().kind() == TrackTarget.Kind.MESH
                && !MaterialProperties.ALL.stream().map(Property::name).toList().contains(track.property());
    }

    private void addText(Object text) {
        digest.update(text.toString().getBytes(StandardCharsets.UTF_8));
        digest.update((byte) '\n');
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException impossible) {
            throw new AssertionError("every Java platform has SHA-256", impossible);
        }
    }
}
