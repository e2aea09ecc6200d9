/**
 * The visible part of the light at a tile's points. Each method is compiled by itself ({@code StageInlining}).
 */
package dev.twister.engine.vector.shadow;
