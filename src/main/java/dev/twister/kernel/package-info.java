/**
 * The device-portable kernel: static methods over primitives and primitive arrays, which the JVM runs as they are and
 * TornadoVM compiles for OpenCL, PTX and CUDA. Leans on nothing at all, no other package of Twister and nothing of the
 * JDK but {@code Math.sqrt}, {@code min}, {@code max} and {@code abs}.
 *
 * <p>The style is narrow on purpose, because TornadoVM silently miscompiles more than this: nested {@code if} and
 * {@code for} with one entry and one exit, loops that end by their condition with an {@code int} flag, conditions
 * combined as ints or by nesting, no {@code break}, {@code continue} or {@code return} inside a loop, no {@code ||} or
 * {@code &&}.
 */
package dev.twister.kernel;
