package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import uk.ac.manchester.tornado.api.TaskGraph;
import uk.ac.manchester.tornado.api.TornadoExecutionPlan;
import uk.ac.manchester.tornado.api.TornadoProfilerResult;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.enums.DataTransferMode;
import uk.ac.manchester.tornado.api.enums.ProfilerMode;
import uk.ac.manchester.tornado.api.exceptions.TornadoExecutionPlanException;

/** Runs one of {@link HelperKernels} on a device and on the JVM, with proof that the device ran it. */
final class HelperRun implements AutoCloseable {
    final float[] first;
    final float[] second;
    final float[] third;
    final float[] input;
    private final int items;
    private final float[] output;
    private final String helper;
    private final TornadoExecutionPlan plan;

    /** Allocates tables of these lengths; input and tables may be refilled between runs. */
    HelperRun(
            String helper,
            TornadoDevice device,
            int items,
            int inputs,
            int outputs,
            int firstTable,
            int secondTable,
            int thirdTable) {
        this.helper = helper;
        this.items = items;
        input = new float[items * inputs];
        output = new float[items * outputs];
        first = new float[firstTable];
        second = new float[secondTable];
        third = new float[thirdTable];
        HelperTask kernel =
                DeviceClassLoader.load(HelperKernels.class, HelperTasks.class).named(helper);
        TaskGraph graph = new TaskGraph("helper")
                .transferToDevice(DataTransferMode.EVERY_EXECUTION, input, first, second, third, output)
                .task(helper, kernel, input, first, second, third, output, items)
                .transferToHost(DataTransferMode.EVERY_EXECUTION, output);
        plan = new TornadoExecutionPlan(graph.snapshot());
        plan.withDevice(device).withProfiler(ProfilerMode.SILENT);
    }

    float[] onDevice() {
        Arrays.fill(output, Float.NaN);
        TornadoProfilerResult profile = plan.execute().getProfilerResult();
        assertThat(profile.getDeviceKernelTime())
                .as("nanoseconds in the kernel of %s", helper)
                .isPositive();
        assertThat(profile.getTotalBytesCopyOut())
                .as("bytes read back by %s", helper)
                .isPositive();
        return output.clone();
    }

    float[] onJvm() {
        float[] expected = new float[output.length];
        new HelperKernels().get().named(helper).apply(input, first, second, third, expected, items);
        return expected;
    }

    @Override
    public void close() throws TornadoExecutionPlanException {
        plan.freeDeviceMemory();
        plan.close();
    }
}
