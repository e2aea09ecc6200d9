/**
 * The visible part of the light at a tile's points. What has columns as its first parameter is compiled by itself
 * ({@code StageInlining}).
 */
package dev.twister.engine.vector.shadow;
