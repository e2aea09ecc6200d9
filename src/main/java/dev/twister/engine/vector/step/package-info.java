/**
 * The steps of a path in lanes, as in the kernel: camera ({@code CameraLanes}), hits ({@code NearestSphere},
 * {@code GroundHit}, {@code HitSorting}), surfaces ({@code SphereSurface}, {@code GroundSurface}), light
 * ({@code LightDirection}, {@code LightHit}, {@code Highlight}), scattering ({@code ScatterLanes}), sky
 * ({@code SkyDirection}, {@code SkyRadiance}) and tone mapping ({@code ToneLanes}, {@code TileOutput}). Methods whose
 * first parameter is a tile or its columns are compiled separately ({@code StageInlining}).
 */
package dev.twister.engine.vector.step;
