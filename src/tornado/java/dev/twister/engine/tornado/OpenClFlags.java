package dev.twister.engine.tornado;

/** Options for OpenCL drivers under which a device rounds each operation as Java does. */
final class OpenClFlags {
    /**
     * Puts {@code #pragma OPENCL FP_CONTRACT OFF} in front of the kernel: OpenCL C fuses multiplications and additions
     * by default. Comments stand for the spaces, at which drivers would cut the option.
     */
    private static final String NO_CONTRACTION =
            "-DPRAGMA(x)=_Pragma(#x) -D__kernel=PRAGMA(OPENCL/**/FP_CONTRACT/**/OFF)__kernel";

    private static final String EXACT_DIVISION = "-cl-fp32-correctly-rounded-divide-sqrt";

    private OpenClFlags() {}

    /**
     * @param platform the name of the OpenCL platform. Exact divisions and square roots are asked of NVIDIA's alone: a
     *     driver may refuse the option, and the pictures of Intel's are the same with it
     */
    static String forPlatform(String platform) {
        String always = "-w " + NO_CONTRACTION;
        return platform.contains("NVIDIA") ? always + " " + EXACT_DIVISION : always;
    }
}
