package dev.twister.bench.device;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.bench.device.CheckedEngine.CheckedPicture;
import dev.twister.bench.report.JsonReport;
import dev.twister.bench.report.ReportFields;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Writes a check as JSON; measurements use the same names as in a benchmark. */
public final class DeviceCheckJson {
    private DeviceCheckJson() {}

    /**
     * Writes the check; on failure the file is unchanged.
     *
     * @throws IOException as for {@link JsonReport#write}
     */
    public static void write(DeviceCheckPlan plan, List<CheckedEngine> engines, Path file) throws IOException {
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("machine", ReportFields.ofMachine(MachineInfo.ofThisMachine()));
        tree.put("pictureSize", plan.pictureSize().toString());
        tree.put("engines", engines.stream().map(DeviceCheckJson::fields).toList());
        tree.put("passed", engines.stream().allMatch(CheckedEngine::passed));
        JsonReport.write(tree, file);
    }

    private static Map<String, Object> fields(CheckedEngine checked) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("engine", checked.engine());
        fields.put("device", checked.device());
        checked.driver().ifPresent(version -> fields.put("driver", version));
        checked.compileSeconds().ifPresent(seconds -> fields.put("compileSeconds", ReportNumbers.rounded(seconds)));
        checked.obstacle().ifPresent(obstacle -> fields.put("obstacle", obstacle));
        checked.failure().ifPresent(failure -> fields.put("failure", failure));
        fields.put("passed", checked.passed());
        fields.put(
                "pictures",
                checked.scenes().stream().map(DeviceCheckJson::picture).toList());
        fields.put(
                "results",
                checked.timed().stream()
                        .flatMap(report -> report.measurements().stream()
                                .map(measurement -> ReportFields.ofMeasurement(report, measurement)))
                        .toList());
        return fields;
    }

    private static Map<String, Object> picture(CheckedPicture picture) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("scene", picture.name());
        fields.put("pixels", picture.comparison().pixels());
        ReportFields.putComparison(fields, picture.comparison());
        return fields;
    }
}
