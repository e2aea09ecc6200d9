package dev.twister.motion;

import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Sphere;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Objects;

/**
 * A digest of everything in a scene that affects the motion of its bodies. Colors, cameras, skies and settings do not.
 */
final class MotionDigest {
    static final int BYTES = 32;

    private MotionDigest() {}

    /** SHA-256 of the data that the motion depends on. */
    static byte[] of(Scene scene) {
        MessageDigest digest = sha256();
        add(digest, scene.physics());
        add(digest, scene.ground().size());
        add(digest, scene.ground().height());
        add(digest, scene.lights().first().position());
        add(digest, scene.lights().first().radius());
        add(digest, scene.pour().map(pour -> pour.withMaterial(Material.DEFAULT)));
        for (Sphere sphere : scene.spheres()) {
            add(digest, sphere.position());
            add(digest, sphere.radius());
        }
        for (Mesh mesh : scene.meshes()) {
            // Only the file's name: the folder may differ between the machines of a farm.
            add(digest, mesh.file().getFileName());
            add(digest, mesh.position());
            add(digest, mesh.rotation());
            add(digest, mesh.scale());
        }
        return digest.digest();
    }

    // The text of records and numbers is exact.
    private static void add(MessageDigest digest, Object part) {
        digest.update(Objects.toString(part).getBytes(StandardCharsets.UTF_8));
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
