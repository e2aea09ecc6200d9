/**
 * The data that all steps work on, and what takes and returns vectors: {@code Lanes}, a tile's columns, and lists. The
 * compiler always inlines all of it ({@code StageInlining}), so what belongs here is small.
 */
package dev.twister.engine.vector.lanes;
