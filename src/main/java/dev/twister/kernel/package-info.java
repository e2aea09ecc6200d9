/**
 * The device-portable kernel: static methods over primitives and primitive arrays, which the JVM runs as they are and
 * TornadoVM compiles for OpenCL, CUDA and Metal. Leans on nothing at all, no other package of Twister and nothing of
 * the JDK but {@code Math.sqrt}, {@code min}, {@code max} and {@code abs}.
 *
 * <p>{@code PixelKernel} draws one pixel, on the JVM and on every device, sample by sample: {@code Camera} starts a
 * path, {@code Path} follows it. At each bounce {@code Hit} finds the body, {@code Surface} the point and the normal,
 * {@code Material} what it is made of, {@code Light} and {@code Shadow} how it is lit, and {@code Scatter} adds that
 * and turns the ray; {@code Sky} ends a path, {@code Tone} stores the pixel. Steps hand their results on in the array
 * {@code path}.
 *
 * <p>The style is narrow on purpose, because TornadoVM silently miscompiles more than this: nested {@code if},
 * {@code for} and {@code while} with one entry and one exit, loops that end by their condition with an {@code int}
 * flag, conditions combined as ints or by nesting, no {@code break}, {@code continue} or {@code return} inside a loop,
 * no {@code ||}, and {@code &&} only between the limit and the flag of a {@code for}: there it is compiled as it should
 * be.
 */
package dev.twister.kernel;
