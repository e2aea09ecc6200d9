package dev.twister.scene;

/** A place or a displacement in meters; x points right, y up, z into the picture. */
public record Vector3(double x, double y, double z) {}
