package dev.twister.bench.device;

import dev.twister.bench.ReportNumbers;
import dev.twister.bench.benchmark.BenchmarkPlan;
import dev.twister.bench.benchmark.MachineInfo;
import dev.twister.bench.benchmark.Measurement;
import dev.twister.bench.benchmark.Measurement.DeviceTimes;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.device.CheckedEngine.CheckedPicture;
import dev.twister.bench.report.ReportTable;
import dev.twister.engine.EngineOffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A check as a Markdown table that is also readable as plain text. It is written line by line, because an engine may
 * crash the process.
 */
public final class DeviceCheckTable {
    private static final String NONE = "-";

    private final DeviceCheckPlan plan;
    private final List<String> titles;
    private final List<Integer> widths;

    /** A table for these engines, whose names determine the widths of columns. */
    public DeviceCheckTable(DeviceCheckPlan plan, List<EngineOffer> offers) {
        this.plan = plan;
        titles = List.of(
                "engine",
                "device",
                "driver",
                "compiles s",
                shading(plan.quick()) + " ms",
                shading(plan.slow()) + " ms",
                "copy in ms",
                "copy out ms",
                "picture");
        List<Stream<String>> texts = List.of(
                offers.stream().map(EngineOffer::id),
                offers.stream().map(offer -> cell(offer.device())),
                offers.stream().map(offer -> cell(offer.driver().orElse(NONE))));
        widths = new ArrayList<>();
        for (int column = 0; column < titles.size() - 1; column++) {
            Stream<String> known = column < texts.size() ? texts.get(column) : Stream.empty();
            widths.add(Stream.concat(known, Stream.of(titles.get(column)))
                    .mapToInt(String::length)
                    .max()
                    .orElseThrow());
        }
    }

    private static String shading(Setting setting) {
        return setting.shadowSamples() + "/" + setting.bounces();
    }

    /** The machine, an explanation of the columns, and their titles. */
    public String heading(List<CheckedScene> scenes, CheckedScene timed) {
        List<String> lines = new ArrayList<>();
        ReportTable.machine(MachineInfo.ofThisMachine()).forEach(line -> lines.add("- " + cell(line)));
        lines.add("- pictures at " + plan.pictureSize() + " beside " + BenchmarkPlan.REFERENCE + "'s: "
                + scenes.stream().map(CheckedScene::name).collect(Collectors.joining(", ")));
        lines.add("- times of the kernel, and of copies at " + shading(plan.quick()) + ": " + timed.name() + " at "
                + plan.timedSize() + " with shadow samples/bounces, mean of up to " + plan.frames() + " frames");
        lines.add("");
        lines.add(row(titles));
        lines.add(row(rules()));
        return String.join(System.lineSeparator(), lines);
    }

    private List<String> rules() {
        List<String> rules = new ArrayList<>();
        for (int column = 0; column < titles.size(); column++) {
            int width = column < widths.size()
                    ? widths.get(column)
                    : titles.getLast().length();
            rules.add(isNumber(column) ? "-".repeat(width - 1) + ":" : "-".repeat(width));
        }
        return rules;
    }

    /** The row of an engine. */
    public String row(CheckedEngine checked) {
        Optional<Measurement> quick = checked.at(plan.quick());
        Optional<DeviceTimes> copies = quick.flatMap(Measurement::deviceTimes);
        return row(List.of(
                checked.engine(),
                cell(checked.device()),
                cell(checked.driver().orElse(NONE)),
                number(checked.compileSeconds(), 1),
                number(quick.map(DeviceCheckTable::kernel), 2),
                number(checked.at(plan.slow()).map(DeviceCheckTable::kernel), 2),
                number(copies.map(DeviceTimes::copyIn), 2),
                number(copies.map(DeviceTimes::copyOut), 2),
                cell(verdict(checked))));
    }

    /** On the JVM, the kernel's time is that of the whole frame. */
    private static double kernel(Measurement measurement) {
        return measurement
                .deviceTimes()
                .map(DeviceTimes::kernel)
                .orElse(measurement.times().mean());
    }

    private static String number(Optional<Double> value, int decimals) {
        return value.map(number -> ReportNumbers.legible(number, decimals)).orElse(NONE);
    }

    private static String verdict(CheckedEngine checked) {
        List<CheckedPicture> wrong = checked.wrongPictures();
        List<String> said = new ArrayList<>();
        checked.obstacle().ifPresent(obstacle -> said.add("does not work here: " + obstacle));
        checked.failure().ifPresent(failure -> said.add("FAILED: " + failure));
        if (!wrong.isEmpty()) {
            said.add("WRONG: " + wrong.stream().map(CheckedPicture::difference).collect(Collectors.joining(", ")));
        } else if (said.isEmpty()) {
            said.add("within tolerance: " + sum(checked, true) + " of " + sum(checked, false) + " pixels off");
        }
        return String.join("; ", said);
    }

    private static int sum(CheckedEngine checked, boolean differing) {
        return checked.pictures().stream()
                .map(CheckedPicture::comparison)
                .mapToInt(picture -> differing ? picture.differingPixels() : picture.pixels())
                .sum();
    }

    /** Joins lines and escapes cell separators. */
    private static String cell(String text) {
        return text.replaceAll("\\s*\\R\\s*", " ").replace("|", "\\|");
    }

    private String row(List<String> cells) {
        StringBuilder line = new StringBuilder("|");
        for (int column = 0; column < cells.size(); column++) {
            String text = cells.get(column);
            int width = column < widths.size() ? widths.get(column) : 0;
            String padding = " ".repeat(Math.max(0, width - text.length()));
            line.append(' ')
                    .append(isNumber(column) ? padding + text : text + padding)
                    .append(" |");
        }
        return line.toString();
    }

    private boolean isNumber(int column) {
        return column > 2 && column < titles.size() - 1;
    }
}
