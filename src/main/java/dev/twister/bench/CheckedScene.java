package dev.twister.bench;

import dev.twister.world.World;

/** A scene to compare pictures in; its picture's size gives way to the check's. */
public record CheckedScene(String name, World world) {}
