/**
 * The engine {@code vector}: packets of pixels in the CPU's SIMD lanes (Vector API), tiles over all cores. The
 * equations are the kernel's, written anew for lanes. Leans on the engine package, the kernel, whose constants and simple
 * functions it takes, the world's frame input, the image package, and {@code threads}; only who looks for engines finds it.
 *
 * <p>A tile is drawn in stages. Each stage is one short loop over the tile's packets, reads and writes {@code float[]}
 * columns of the {@link dev.twister.engine.vector.Tile}, and holds vectors in local variables only. That is on purpose:
 * past some 60 vector operations, or 325 bytecodes, a method is no longer inlined whole, and vectors become objects. So the compiler
 * is told to inline no stage ({@link dev.twister.engine.vector.StageInlining}). For the same reason no
 * method but those of {@code Lanes}, which are always inlined, takes or returns a vector: once in some dozens of JVMs a helper
 * is not inlined, for good. A stage is not run for an empty list of packets, as the compiler makes objects in a loop that hardly
 * any call comes to.
 *
 * <p>What a whole tile has in common is found once: which bodies its rays may meet ({@link dev.twister.engine.vector.Hull}), where
 * in the sky its view rays look ({@link dev.twister.engine.vector.SkyChart}) and at which texels
 * ({@link dev.twister.engine.vector.SkyWindow}), and that all of them meet nothing, or the ground
 * ({@link dev.twister.engine.vector.GroundAlone}).
 *
 * <p>Where a product is added in one step, that is {@code Lanes.fma}, as not every CPU has the Vector API's own. From the view ray
 * by way of what it meets to the next ray no product is: products and sums are rounded there as the kernel rounds them, in its
 * order, as a crowd of small mirrors shows every other bit. Tiles of ground alone, of which a crowd has none, are drawn their own way.
 */
package dev.twister.engine.vector;
