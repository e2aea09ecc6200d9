/**
 * The device-portable kernel: static methods over primitives and primitive arrays, which run on the JVM and are
 * compiled by TornadoVM for OpenCL, CUDA and Metal. It depends on no other package of Twister, and of the JDK only on
 * {@code Math.sqrt}, {@code min}, {@code max} and {@code abs}.
 *
 * <p>{@code PixelKernel} renders one pixel, on the JVM and on every device, sample by sample: {@code CameraRay} starts
 * a path, {@code Path} follows it. At each bounce {@code Hit} finds the body, {@code Surface} the point and the normal,
 * {@code SurfaceLook} the material, {@code Illumination} and {@code Shadow} the illumination, and {@code Scatter} adds
 * the reflected light and the next ray; {@code SkyLookup} ends a path, {@code Tone} encodes the pixel. Steps pass their
 * results in the array {@code path}. If paths are traced, {@code PathTracer} follows them instead, with {@code Lobes}
 * for the surfaces and {@code Emitter} for the light.
 *
 * <p>The style is restricted because TornadoVM silently miscompiles other constructs: nested {@code if}, {@code for}
 * and {@code while} with one entry and one exit; loops that end by their condition with an {@code int} flag; conditions
 * combined as ints or by nesting; no {@code break}, {@code continue} or {@code return} inside a loop; no {@code ||};
 * and {@code &&} only between the limit and the flag of a {@code for}, where it compiles correctly.
 */
package dev.twister.kernel;
