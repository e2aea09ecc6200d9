package dev.twister.scene;

/** A linear color (albedo or radiance); each component is 0 or more, for an albedo at most 1. */
public record Rgb(double red, double green, double blue) {}
