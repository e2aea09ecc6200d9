package dev.twister.oracle;

import dev.twister.scene.Scene;
import dev.twister.sky.Skybox;

/** A scene with a sky that is in no file. */
public record RandomScene(Scene scene, Skybox sky) {}
