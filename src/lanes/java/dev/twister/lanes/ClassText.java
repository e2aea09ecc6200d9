package dev.twister.lanes;

import dev.twister.lanes.Statement.LaneIf;
import dev.twister.lanes.Statement.LaneLoop;
import dev.twister.lanes.Statement.UniformIf;
import dev.twister.lanes.Statement.UniformLoop;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Writes a class: the units, and a driver that calls them for lists of packets. */
final class ClassText {
    private final Lines lines = new Lines();
    private final List<UnitText> units = new ArrayList<>();

    /** Most lists of packets at a time, which is how deep the driver's control flow is. */
    private int lists;

    /** Writes the class of a program. */
    ClassText(String packageName, String className, String method, Plan plan, Lifetimes lifetimes) {
        plan.units.forEach(unit -> units.add(new UnitText(unit, lifetimes)));
        lines.add("package " + packageName + ";");
        lines.add("");
        lines.add("import dev.twister.engine.vector.lanes.Lanes;");
        for (String name : List.of("FloatVector", "IntVector", "VectorMask", "VectorOperators", "VectorSpecies")) {
            lines.add("import jdk.incubator.vector." + name + ";");
        }
        lines.add("import javax.annotation.processing.Generated;");
        lines.add("");
        lines.add("/** The kernel's {@code " + method + "} for lists of packets. Made by dev.twister.lanes. */");
        lines.add("@Generated(\"dev.twister.lanes\")");
        lines.block("public final class " + className, () -> {
            lines.add("private static final VectorSpecies<Float> FLOATS = Lanes.FLOATS;");
            lines.add("private static final VectorSpecies<Integer> INTS = Lanes.INTS;");
            lines.add("private static final IntVector NUMBERS = Lanes.numbers();");
            lines.add("");
            lines.add("private " + className + "() {}");
            lines.add("");
            for (UnitText unit : units) {
                unit.writeTo(lines);
            }
            lines.add("/** Runs the packets of a list, in the lanes of their first masks. */");
            lines.block("public static void run(PathColumns c, int[] list0, int count0)", () -> {
                lines.add("long[] masks = c.masks;");
                for (String array : UnitText.SHARED) {
                    lines.add("float[] " + array + " = c." + array + ";");
                }
                lines.add("int variant = c.variant;");
                write(plan.steps, 0);
            });
        });
    }

    /** The lists that the driver needs. */
    int lists() {
        return lists + 1;
    }

    @Override
    public String toString() {
        return lines.toString();
    }

    private void write(List<Plan.Step> steps, int depth) {
        lists = Math.max(lists, depth);
        for (Plan.Step step : steps) {
            switch (step) {
                case Plan.Step.Call(Plan.Unit unit) -> {
                    String indexes = units.get(unit.number()).indexes().stream()
                            .map(index -> ", " + index)
                            .collect(Collectors.joining());
                    lines.add("unit" + unit.number() + "(c, list" + depth + ", count" + depth + indexes + ");");
                }
                case Plan.Step.Flow(Statement statement, List<List<Plan.Step>> blocks) ->
                    writeFlow(statement, blocks, depth);
            }
        }
    }

    private void writeFlow(Statement statement, List<List<Plan.Step>> blocks, int depth) {
        int next = depth + 1;
        switch (statement) {
            case LaneIf choice ->
                lines.block("", () -> {
                    lines.add("int[] list" + next + " = c.lists[" + next + "];");
                    lines.add("int count" + next + " = c.filter(masks, " + choice.mask().column + ", list" + depth
                            + ", count" + depth + ", list" + next + ");");
                    lines.block("if (count" + next + " > 0)", () -> write(blocks.getFirst(), next));
                });
            case UniformIf choice -> {
                lines.block("if (" + choice.condition() + ")", () -> write(blocks.getFirst(), depth));
                if (!blocks.getLast().isEmpty()) {
                    lines.block("if (!(" + choice.condition() + "))", () -> write(blocks.getLast(), depth));
                }
            }
            case LaneLoop loop ->
                lines.block("", () -> {
                    lines.add("int[] list" + next + " = c.lists[" + next + "];");
                    lines.add("int count" + next + " = PathColumns.copy(list" + depth + ", count" + depth + ", list"
                            + next + ");");
                    lines.block("while (true)", () -> {
                        write(blocks.getFirst(), next);
                        lines.add("count" + next + " = c.filter(masks, " + loop.mask().column + ", list" + next
                                + ", count" + next + ", list" + next + ");");
                        lines.block("if (count" + next + " == 0)", () -> lines.add("break;"));
                        write(blocks.getLast(), next);
                    });
                });
            case UniformLoop loop ->
                lines.block(
                        "for (int " + loop.index() + " = " + loop.from() + "; " + loop.condition() + "; " + loop.index()
                                + " = " + loop.next() + ")",
                        () -> write(blocks.getFirst(), depth));
            default -> throw new Refusal("a statement without control flow");
        }
    }
}
