/**
 * The compiler from the kernel's Java to lanes: it reads methods of {@code dev.twister.kernel}, and writes classes on
 * the Vector API that run them for many paths at once, equal to the scalar methods in every bit. It is a part of the
 * build.
 *
 * <p>{@link dev.twister.lanes.Statements} runs a method for lanes whose values it does not know, which gives
 * {@link dev.twister.lanes.Statement}s; {@link dev.twister.lanes.ClassText} writes these as Java.
 */
package dev.twister.lanes;
