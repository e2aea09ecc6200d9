/**
 * The device-portable kernel: static methods over primitives and primitive arrays, which the JVM runs as they are and
 * TornadoVM compiles for OpenCL, PTX and CUDA. Leans on nothing at all, no other package of Twister and nothing of the
 * JDK but {@code Math.sqrt}, {@code min}, {@code max} and {@code abs}; {@code PlainShadow}, which devices never run, takes
 * the JDK's sine and cosine too.
 *
 * <p>{@code PixelKernel} draws one pixel, for the JVM and for GPUs. {@code StripKernel} takes the same steps in another
 * order, each for {@code Strip.LANES} neighbours in a loop of its own, for the compilers of CPUs' OpenCL: its loops
 * are short, store in arrays of their own only, have no branch that leads to another loop, and compare no number with
 * two others for being the same, of which LLVM would make a {@code switch} that it does not vectorize.
 *
 * <p>The style is narrow on purpose, because TornadoVM silently miscompiles more than this: nested {@code if}, {@code for}
 * and {@code while} with one entry and one exit, loops that end by their condition with an {@code int} flag, conditions
 * combined as ints or by nesting, no {@code break}, {@code continue} or {@code return} inside a loop, no {@code ||}, and
 * {@code &&} only between the limit and the flag of a {@code for}: there it is compiled as it should be.
 */
package dev.twister.kernel;
