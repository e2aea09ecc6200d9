package dev.twister.bench.report;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.Statistics;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.bench.benchmark.Measurement;
import dev.twister.bench.benchmark.PaperFigure;
import dev.twister.bench.benchmark.PictureComparison;
import dev.twister.bench.benchmark.Setting;
import dev.twister.engine.JvmEngines;
import dev.twister.scene.Integrator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Fields of a report, with the names that JSON and CSV share. No value is null; unknown fields are absent. */
public final class ReportFields {
    private ReportFields() {}

    public static Map<String, Object> ofMachine(MachineInfo machine) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("processor", machine.processor());
        fields.put("cores", machine.cores());
        fields.put("memoryBytes", machine.memoryBytes());
        fields.put("maxHeapBytes", machine.maxHeapBytes());
        fields.put("operatingSystem", machine.operatingSystem());
        fields.put("jdk", machine.jdk());
        fields.put("jdkVendor", machine.vendor());
        fields.put("jit", machine.jit());
        fields.put("twister", machine.twister());
        machine.tornadoVm().ifPresent(version -> fields.put("tornadoVm", version));
        return fields;
    }

    /** The plan's fields, with shadow samples and bounces only if they are the same at all settings. */
    static Map<String, Object> ofPlan(BenchmarkReport report) {
        BenchmarkPlan plan = report.plan();
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("scene", report.scene());
        if (plan.hasOneFigure()) {
            fields.put("shadowSamples", plan.settings().getFirst().shadowSamples());
            fields.put("bounces", plan.settings().getFirst().bounces());
            putPaths(fields, plan.settings().getFirst());
        }
        fields.put("plannedWarmupFrames", plan.warmupFrames());
        fields.put("plannedFrames", plan.frames());
        fields.put("maxSeconds", plan.maxSeconds());
        return fields;
    }

    /** One row per engine and setting of the figure. */
    static List<Map<String, Object>> ofFigure(BenchmarkReport report, PaperFigure figure) {
        return report.plan().settings(figure).stream()
                .flatMap(setting -> report.measurements().stream()
                        .filter(measurement -> measurement.setting().equals(setting)))
                .map(measurement -> ofMeasurement(report, measurement))
                .toList();
    }

    public static Map<String, Object> ofMeasurement(BenchmarkReport report, Measurement measurement) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("engine", measurement.engine());
        fields.put("device", measurement.device());
        fields.put("width", measurement.setting().size().width());
        fields.put("height", measurement.setting().size().height());
        fields.put("shadowSamples", measurement.setting().shadowSamples());
        fields.put("bounces", measurement.setting().bounces());
        putPaths(fields, measurement.setting());
        fields.put("bodies", measurement.bodies());
        fields.put("warmupFrames", measurement.warmupFrames());
        putTimes(fields, measurement);
        report.speedupOver(JvmEngines.SEQUENTIAL, measurement)
                .ifPresent(factor -> fields.put("speedupOverSequential", ReportNumbers.rounded(factor)));
        report.speedupOver(JvmEngines.PARALLEL, measurement)
                .ifPresent(factor -> fields.put("speedupOverParallel", ReportNumbers.rounded(factor)));
        putComparison(fields, measurement.comparison());
        return fields;
    }

    public static void putComparison(Map<String, Object> fields, PictureComparison comparison) {
        fields.put("differingPixels", comparison.differingPixels());
        fields.put("allowedDifferingPixels", comparison.allowedPixels());
        fields.put("largestDifference", comparison.largestDifference());
        fields.put("samePicture", comparison.withinTolerance());
    }

    private static void putPaths(Map<String, Object> fields, Setting setting) {
        setting.paths().ifPresent(samples -> {
            fields.put("integrator", Integrator.PATH.name().toLowerCase(Locale.ROOT));
            fields.put("samplesPerPixel", samples);
        });
    }

    static void putMilliseconds(Map<String, Object> fields, Statistics times) {
        fields.put("msMin", ReportNumbers.rounded(times.min()));
        fields.put("msMedian", ReportNumbers.rounded(times.median()));
        fields.put("msMean", ReportNumbers.rounded(times.mean()));
        fields.put("msP95", ReportNumbers.rounded(times.p95()));
    }

    private static void putTimes(Map<String, Object> fields, Measurement measurement) {
        Statistics times = measurement.times();
        fields.put("frames", times.frames());
        fields.put("fps", ReportNumbers.rounded(times.fps()));
        measurement
                .setting()
                .pathsPerSecond(times.fps())
                .ifPresent(rate -> fields.put("samplesPerSecond", Math.round(rate)));
        putMilliseconds(fields, times);
        measurement.deviceTimes().ifPresent(device -> {
            fields.put("msKernel", ReportNumbers.rounded(device.kernel()));
            fields.put("msCopyIn", ReportNumbers.rounded(device.copyIn()));
            fields.put("msCopyOut", ReportNumbers.rounded(device.copyOut()));
        });
        measurement.motionTimes().ifPresent(motion -> {
            fields.put("msStep", ReportNumbers.rounded(motion.step()));
            fields.put("msRebuild", ReportNumbers.rounded(motion.rebuild()));
        });
    }
}
