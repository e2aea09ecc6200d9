package dev.twister.bench;

import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/** The evaluation for programs. */
final class PaperJson {
    private PaperJson() {}

    static void write(PaperReport report, Path file) throws IOException {
        byte[] json = JsonMapper.builder()
                .enable(SerializationFeature.INDENT_OUTPUT)
                .build()
                .writeValueAsBytes(tree(report));
        WholeFile.write(file, out -> {
            out.write(json);
            out.write('\n');
        });
    }

    private static Map<String, Object> tree(PaperReport report) {
        Map<String, Object> figures = new LinkedHashMap<>();
        for (PaperFigure figure : PaperFigure.values()) {
            figures.put(figure.id(), PaperFields.ofFigure(report, figure));
        }
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("machine", ReportFields.ofMachine(report.machine()));
        tree.put("parameters", PaperFields.ofPlan(report));
        tree.put("figures", figures);
        tree.put("published", published(report));
        tree.put(
                "failures",
                report.failures().stream()
                        .map(failure -> Map.of("engine", failure.engine(), "message", failure.message()))
                        .toList());
        tree.put("finished", report.finished());
        tree.put("passed", report.passed());
        return tree;
    }

    private static Map<String, Object> published(PaperReport report) {
        List<Map<String, Object>> fps = report.plan().sizes().stream()
                .filter(size -> PublishedFigures.fps(size).isPresent())
                .map(size -> Map.<String, Object>of(
                        "size",
                        size.toString(),
                        "fps",
                        PublishedFigures.fps(size).orElseThrow()))
                .toList();
        Map<String, Object> tree = new LinkedHashMap<>();
        tree.put("paper", PublishedFigures.PAPER);
        tree.put("device", PublishedFigures.DEVICE);
        tree.put("fpsWithHardShadowsAndOneBounce", fps);
        tree.put("largestSpeedupOverParallel", PublishedFigures.LARGEST_SPEEDUP_OVER_PARALLEL);
        return tree;
    }
}
