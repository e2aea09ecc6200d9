/**
 * The engine {@code vector}: packets of pixels in the CPU's SIMD lanes (Vector API), tiles over all cores. The
 * equations are the kernel's, written anew for lanes. Leans on the engine package, the kernel, whose constants and
 * simple functions it takes, the world's frame input, the image package, and {@code threads}; only who looks for
 * engines finds it.
 *
 * <p>{@link dev.twister.engine.vector.TileRenderer} has the order of the steps of a tile. Each step ({@code .step},
 * {@code .shadow}, {@code .crowd}, {@code .mesh}) and each shortcut ({@code .shortcut}) is some short loops over the
 * tile's packets, each a method, which reads and writes {@code float[]} columns of the
 * {@link dev.twister.engine.vector.lanes.Tile} and holds vectors in local variables only. That is on purpose: past some
 * 60 vector operations, or 325 bytecodes, a method is no longer inlined whole, and vectors become objects. So the
 * compiler is told to inline none that has columns as its first parameter, and all of {@code .lanes} always
 * ({@link dev.twister.engine.vector.StageInlining}). For the same reason nothing outside {@code Lanes} takes or returns
 * a vector. A step is not run for an empty list of packets, as the compiler makes objects in a loop that hardly any
 * call comes to.
 *
 * <p>Where a product is added in one step, that is {@code Lanes.fma}, as not every CPU has the Vector API's own. From
 * the view ray by way of what it meets to the next ray no product is: products and sums are rounded there as the kernel
 * rounds them, in its order, as a crowd of small mirrors shows every other bit. Tiles of ground alone, of which a crowd
 * has none, are drawn their own way.
 */
package dev.twister.engine.vector;
