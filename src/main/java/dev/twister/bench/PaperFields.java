package dev.twister.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The evaluation's facts under the names that its JSON and its CSV share. */
final class PaperFields {
    private PaperFields() {}

    static Map<String, Object> ofPlan(PaperReport report) {
        PaperPlan plan = report.plan();
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("scene", report.scene());
        fields.put("plannedWarmupFrames", plan.warmupFrames());
        fields.put("plannedFrames", plan.frames());
        fields.put("maxSeconds", plan.maxSeconds());
        return fields;
    }

    /** A row for each engine at each of the figure's settings. */
    static List<Map<String, Object>> ofFigure(PaperReport report, PaperFigure figure) {
        List<Map<String, Object>> rows = new ArrayList<>();
        for (PaperSetting setting : report.plan().settings(figure)) {
            for (String engine : report.engines()) {
                report.find(engine, setting)
                        .ifPresent(measurement -> rows.add(ReportFields.ofMeasurement(report, measurement)));
            }
        }
        return rows;
    }
}
