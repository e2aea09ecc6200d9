/**
 * The visible part of the light at a tile's points. Methods whose first parameter is a tile or its columns are compiled
 * separately ({@code StageInlining}).
 */
package dev.twister.engine.vector.shadow;
