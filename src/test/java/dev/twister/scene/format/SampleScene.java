package dev.twister.scene.format;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;

/** The text of a valid scene file, to be spoiled by tests, and the folder from which it can be read. */
final class SampleScene {
    static final String TEXT = """
            {
              "$schema": "scene.schema.json",
              "version": 1,
              "name": "Sample",
              "description": "Every field is here.",
              "camera": {"position": [0, -5, -15], "yaw": 0, "pitch": 7, "fieldOfView": 50},
              "light": {"position": [0, 0, 0], "radius": 1.2, "color": [1, 1, 1]},
              "plane": {"size": 48, "height": -9.75, "colors": [[0.4, 0.4, 0.4], [0.2, 0.2, 0.2]], "reflectivity": 32},
              "skybox": "sky.hdr",
              "shading": {"ambient": 0.25}, "skyRotation": -35, "skyStrength": 2.25,
              "rendering": {"width": 640, "height": 360, "shadowSamples": 16, "bounces": 2, "samplesPerPixel": 4, "exposure": -0.5, "toneMap": "aces", "srgb": true},
              "physics": {"gravity": [0, -1.62, 0], "elasticity": 0.75, "friction": 0.125, "damping": 0.05, "walls": false, "solidLight": true},
              "pour": {"count": 30, "rate": 5.5, "position": [1, 2, 3], "width": 1.25, "speed": 2.5, "radius": [0.2, 0.3], "palette": "lagoon", "reflectivity": 12, "seed": 9},
              "spheres": [
                {"position": [-4, -8, 0], "radius": 1.75, "color": [1, 0, 0], "reflectivity": 24},
                {"position": [0, -8, 0], "radius": 1.5, "color": [0, 1, 0], "reflectivity": 36}
              ]
            }
            """;

    /** Fields that the first version of the format lacks; the folder also contains the texture. */
    static final String MATERIALS = """
            {
              "version": 2,
              "camera": {"position": [0, -5, -15], "yaw": 0, "pitch": 7, "fieldOfView": 50, "aperture": 0.125, "focusDistance": 12.5},
              "light": {"position": [0, 0, 0], "radius": 1.2, "color": [1, 1, 1]},
              "materials": {
                "glass": {"color": [1, 1, 1], "reflectivity": 2, "transmission": 0.75, "ior": 1.6},
                "earth": {"color": [1, 1, 0.5], "reflectivity": 3, "roughness": 0.25, "texture": "earth.png"}
              },
              "plane": {"size": 48, "height": -9.75, "material": "earth", "oddColor": [0.5, 0, 0]},
              "skybox": "sky.hdr",
              "pour": {"count": 30, "rate": 5.5, "position": [1, 2, 3], "width": 1.25, "speed": 2.5, "radius": [0.2, 0.3], "palette": "lagoon", "reflectivity": 12, "roughness": 0.5, "transmission": 1, "ior": 2, "texture": "earth.png", "seed": 9},
              "spheres": [
                {"position": [-4, -8, 0], "radius": 1.75, "material": "glass"},
                {"position": [0, -8, 0], "radius": 1.5, "color": [0, 1, 0], "reflectivity": 36, "roughness": 0.125, "transmission": 0.5, "ior": 1.25, "texture": "earth.png"}
              ]
            }
            """;

    /** Shapes, which need the third version. */
    static final String SHAPES = """
            {
              "version": 3,
              "camera": {"position": [0, 1, -8], "yaw": 0, "pitch": 7, "fieldOfView": 50},
              "light": {"position": [0, 6, 0], "radius": 1.2, "color": [1, 1, 1]},
              "plane": {"size": 48, "height": 0, "colors": [[0.4, 0.4, 0.4], [0.2, 0.2, 0.2]], "reflectivity": 32},
              "skybox": "sky.hdr", "spheres": [],
              "meshes": [
                {"shape": "box", "size": [1, 2, 3], "position": [0, 1, 0]}
              ]
            }
            """;

    private SampleScene() {}

    /** Returns the text with the only occurrence of a part replaced. */
    static String with(String part, String replacement) {
        return with(TEXT, part, replacement);
    }

    /** Returns a text with the only occurrence of a part replaced. */
    static String with(String text, String part, String replacement) {
        if (text.split(Pattern.quote(part), -1).length != 2) {
            throw new IllegalArgumentException("not exactly once in the sample: " + part);
        }
        return text.replace(part, replacement);
    }

    /** Writes a scene file and the pictures that the samples name into a folder. */
    static Path put(Path folder, byte[] bytes) {
        try {
            Files.createDirectories(folder);
            Files.write(folder.resolve("sky.hdr"), new byte[0]);
            Files.write(folder.resolve("earth.png"), new byte[0]);
            return Files.write(folder.resolve("scene.json"), bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static Path put(Path folder, String text) {
        return put(folder, text.getBytes(StandardCharsets.UTF_8));
    }
}
