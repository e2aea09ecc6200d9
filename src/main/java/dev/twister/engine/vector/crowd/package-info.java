/**
 * Traversal of the hierarchy in scenes of many spheres, for rays and for lines to the light. Methods whose first
 * parameter is a tile or its columns are compiled separately ({@code StageInlining}).
 */
package dev.twister.engine.vector.crowd;
