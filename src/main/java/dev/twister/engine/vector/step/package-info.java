/**
 * The steps of a path in lanes, as the kernel has them: the camera ({@code CameraLanes}), hits ({@code NearestSphere},
 * {@code GroundHit}, {@code HitSorting}), surfaces ({@code SphereSurface}, {@code GroundSurface}), the light
 * ({@code LightDirection}, {@code LightHit}, {@code Highlight}), what goes on from there ({@code ScatterLanes}), the
 * sky ({@code SkyDirection}, {@code SkyRadiance}), and tones ({@code ToneLanes}, {@code TileOutput}). What has columns
 * as its first parameter is compiled by itself ({@code StageInlining}).
 */
package dev.twister.engine.vector.step;
