/**
 * Walks through the hierarchy where there are many spheres: which of them rays meet, or lines to the light. What has
 * columns as its first parameter is compiled by itself ({@code StageInlining}).
 */
package dev.twister.engine.vector.crowd;
