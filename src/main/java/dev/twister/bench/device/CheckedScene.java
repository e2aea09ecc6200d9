package dev.twister.bench.device;

import dev.twister.world.World;

/** A scene for comparing pictures; the check overrides its picture size. */
public record CheckedScene(String name, World world) {}
