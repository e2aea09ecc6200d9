package dev.twister.world.hierarchy;

/**
 * Tells by its identity whether two inputs have the same hierarchy over the spheres, though other numbers of the array
 * that has it differ. No part of the picture: all are equal.
 */
public record HierarchyIdentity() {}
