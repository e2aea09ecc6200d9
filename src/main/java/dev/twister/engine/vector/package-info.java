/**
 * The engine {@code vector}: packets of pixels in the CPU's SIMD lanes (Vector API), tiles on all cores. It implements
 * the kernel's equations in lanes and reuses the kernel's constants and simple functions. It depends on the engine
 * package, the kernel, the world's frame input, the image package and {@code threads}; callers reach it only through
 * engine discovery.
 *
 * <p>{@link dev.twister.engine.vector.TileRenderer} runs the samples of a tile,
 * {@link dev.twister.engine.vector.BounceRenderer} the steps of a bounce. Each step ({@code .step}, {@code .shadow},
 * {@code .crowd}, {@code .mesh}) and each shortcut ({@code .shortcut}) consists of short loops over the tile's packets,
 * one loop per method. A loop reads and writes {@code float[]} columns of the
 * {@link dev.twister.engine.vector.lanes.Tile} and holds vectors in local variables only. Methods stay small because
 * beyond about 60 vector operations or 325 bytecodes C2 no longer inlines all calls, and vectors become objects.
 * Directives ({@link dev.twister.engine.vector.StageInlining}) keep C2 from inlining methods whose first parameter is a
 * tile or its columns, and make it inline all of {@code .lanes}. For the same reason only {@code Lanes} takes or
 * returns vectors. A step is skipped where its list of packets is empty, because C2 allocates vectors in loops that it
 * has rarely seen run.
 *
 * <p>{@code Lanes.fma} replaces the Vector API's fused multiply-add, which not every CPU has. From a ray to its hit and
 * on to the next ray, no operation is fused: products and sums are rounded in the kernel's order, because a crowd of
 * small mirrors makes every rounding difference visible. Tiles that show only the ground may differ, because a crowd
 * has none.
 */
package dev.twister.engine.vector;
