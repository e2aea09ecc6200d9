/**
 * The data shared by all steps, and the code that takes and returns vectors: {@code Lanes}, a tile's columns, and
 * lists. C2 always inlines all of it ({@code StageInlining}), so everything here is small.
 */
package dev.twister.engine.vector.lanes;
