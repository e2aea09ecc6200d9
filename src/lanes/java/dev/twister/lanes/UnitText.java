package dev.twister.lanes;

import dev.twister.lanes.Statement.Assignment;
import dev.twister.lanes.Statement.Block;
import dev.twister.lanes.Statement.LaneIf;
import dev.twister.lanes.Statement.LaneLoop;
import dev.twister.lanes.Statement.MaskedAssignment;
import dev.twister.lanes.Statement.Narrowing;
import dev.twister.lanes.Statement.Operation;
import dev.twister.lanes.Statement.PathStore;
import dev.twister.lanes.Statement.ScratchStore;
import dev.twister.lanes.Statement.UniformIf;
import dev.twister.lanes.Statement.UniformLoop;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Writes a unit: a loop over packets, in which vectors are local variables. */
final class UnitText {
    /** The kernel's arrays that all lanes share, and the variant. */
    static final List<String> SHARED = List.of("frame", "bodies", "looks", "meshes", "images");

    private static final int MOST_SOURCES = 4;

    private final Plan.Unit unit;
    private final Lines body = new Lines();

    /** Variables that are declared here. */
    private Set<Variable> known = new HashSet<>();

    /** Results of operations, and mutable variables that are set. */
    private final Set<Variable> defined = new HashSet<>();

    private final Set<Variable> changed = new LinkedHashSet<>();

    /** How many statements read a variable. */
    private final Map<Variable, Integer> uses = new HashMap<>();

    UnitText(Plan.Unit unit, Lifetimes lifetimes) {
        this.unit = unit;
        unit.statements().forEach(this::findDefined);
        unit.statements().forEach(statement -> countUses(statement, uses));
        write(unit.statements());
        for (Variable variable : changed) {
            if (lifetimes.livesAfter(variable, unit)) {
                store(variable);
            }
        }
    }

    /** The loops' indexes that the unit's callers pass. */
    Set<String> indexes() {
        Set<String> found = matches("\\bindex\\d+\\b", 0);
        found.removeAll(matches("int (index\\d+) = ", 1));
        return found;
    }

    private Set<String> matches(String pattern, int group) {
        Set<String> found = new TreeSet<>();
        Matcher matcher = Pattern.compile(pattern).matcher(body.toString());
        while (matcher.find()) {
            found.add(matcher.group(group));
        }
        return found;
    }

    private boolean mentions(String pattern) {
        return Pattern.compile(pattern).matcher(body.toString()).find();
    }

    void writeTo(Lines lines) {
        String indexes = indexes().stream().map(index -> ", int " + index).collect(Collectors.joining());
        lines.add("/** " + sources() + ". */");
        lines.block(
                "private static void unit" + unit.number() + "(PathColumns c, int[] list, int count" + indexes + ")",
                () -> {
                    lines.add("float[] floats = c.floats;");
                    lines.add("int[] ints = c.ints;");
                    lines.add("long[] masks = c.masks;");
                    for (String array : SHARED) {
                        if (mentions("\\b" + array + "\\b")) {
                            lines.add("float[] " + array + " = c." + array + ";");
                        }
                    }
                    if (mentions("\\bscratch\\b")) {
                        lines.add("float[] scratch = c.scratch;");
                    }
                    if (mentions("\\bvariant\\b")) {
                        lines.add("int variant = c.variant;");
                    }
                    lines.block("for (int k = 0; k < count; k++)", () -> {
                        lines.add("int packet = list[k];");
                        lines.add("int f = c.firstFloat(packet);");
                        lines.add("int i = c.firstInt(packet);");
                        lines.add("int m = c.firstMask(packet);");
                        if (mentions("\\bscratch\\b")) {
                            lines.add("int s = c.firstScratch(packet);");
                        }
                        body.toString().lines().forEach(lines::add);
                    });
                });
        lines.add("");
    }

    /** The kernel's methods that the unit has most of. */
    private String sources() {
        Map<String, Integer> counts = new TreeMap<>();
        unit.statements().forEach(statement -> countSources(statement, counts));
        return counts.entrySet().stream()
                .sorted((a, b) -> b.getValue() - a.getValue())
                .limit(MOST_SOURCES)
                .map(Map.Entry::getKey)
                .collect(Collectors.joining(", ", "Of ", ""));
    }

    private static void countSources(Statement statement, Map<String, Integer> counts) {
        switch (statement) {
            case Operation operation -> counts.merge(operation.source(), 1, Integer::sum);
            case PathStore store -> counts.merge(store.source(), 1, Integer::sum);
            case ScratchStore store -> counts.merge(store.source(), 1, Integer::sum);
            default -> statement.blocks().forEach(block -> block.list().forEach(inner -> countSources(inner, counts)));
        }
    }

    private void findDefined(Statement statement) {
        if (statement instanceof Operation operation) {
            defined.add(operation.result());
        }
        statement.forEachSet(changed::add);
        statement.blocks().forEach(block -> block.list().forEach(this::findDefined));
    }

    /** Declares what a statement reads, and what its blocks set, unless it is declared. */
    private void declareFor(Statement statement) {
        if (!(statement instanceof Operation operation && isGather(operation))) {
            statement.forEachRead(this::declare);
        }
        statement.blocks().forEach(block -> declareFor(block, Plan.isLoop(statement)));
    }

    /** As above; what a block that runs once has to itself is declared inside. */
    private void declareFor(Block block, boolean isRepeated) {
        Map<Variable, Integer> inside = new LinkedHashMap<>();
        block.list().forEach(statement -> countUses(statement, inside));
        inside.forEach((variable, count) -> {
            if (isRepeated || variable.isMutable || count < uses.get(variable)) {
                declare(variable);
            }
        });
    }

    private static void countUses(Statement statement, Map<Variable, Integer> counts) {
        if (!(statement instanceof Operation operation && isGather(operation))) {
            statement.forEachRead(variable -> counts.merge(variable, 1, Integer::sum));
        }
        statement.forEachSet(variable -> counts.merge(variable, 1, Integer::sum));
        statement.blocks().forEach(block -> block.list().forEach(inner -> countUses(inner, counts)));
    }

    /** Whether its places are read from their column. */
    private static boolean isGather(Operation operation) {
        return operation.name().equals("gather") || operation.name().equals("scratch");
    }

    private void declare(Variable variable) {
        boolean isOwn = !variable.isMutable && defined.contains(variable);
        if (!isOwn && known.add(variable)) {
            Kind kind = variable.kind;
            String value = variable.hasColumn ? loaded(variable) : OperationText.lanes(kind, zero(kind));
            body.add((variable.isMutable ? "" : "final ") + kind.type + " " + variable + " = " + value + ";");
        }
    }

    private static Value zero(Kind kind) {
        return switch (kind) {
            case FLOAT -> new Value.Constant(0f);
            case INT -> new Value.Constant(0);
            case MASK -> new Value.Constant(false);
        };
    }

    private static String loaded(Variable variable) {
        String place = OperationText.place(variable);
        return switch (variable.kind) {
            case FLOAT -> "FloatVector.fromArray(FLOATS, " + place + ")";
            case INT -> "IntVector.fromArray(INTS, " + place + ")";
            case MASK -> "VectorMask.fromLong(FLOATS, " + place + ")";
        };
    }

    private void store(Variable variable) {
        String place = OperationText.place(variable);
        body.add(
                variable.kind == Kind.MASK
                        ? place + " = " + variable + ".toLong();"
                        : variable + ".intoArray(" + place + ");");
    }

    private void write(Block block) {
        Set<Variable> outer = known;
        known = new HashSet<>(known);
        write(block.list());
        known = outer;
    }

    private void write(List<Statement> statements) {
        for (Statement statement : statements) {
            declareFor(statement);
            write(statement);
        }
    }

    private void write(Statement statement) {
        switch (statement) {
            case Operation operation -> {
                Variable result = operation.result();
                body.add("final " + result.kind.type + " " + result + " = " + OperationText.of(operation) + ";");
                known.add(result);
                if (result.hasColumn) {
                    store(result);
                }
            }
            case PathStore store ->
                body.add(OperationText.lanes(Kind.FLOAT, store.value()) + ".intoArray(floats, f + "
                        + OperationText.WIDTH * store.place() + ", " + store.mask() + ");");
            case ScratchStore store -> {
                String lanes = store.lanes() == null ? "" : ", " + OperationText.place(store.lanes());
                body.add(OperationText.lanes(Kind.FLOAT, store.value()) + ".intoArray(scratch, s + "
                        + OperationText.WIDTH + " * (" + store.place() + ")" + lanes + ", " + store.mask() + ");");
            }
            case Assignment set -> {
                Variable variable = set.variable();
                String type = known.add(variable) ? variable.kind.type + " " : "";
                body.add(type + variable + " = " + OperationText.lanes(variable.kind, set.value()) + ";");
            }
            case MaskedAssignment set -> body.add(masked(set));
            case Narrowing set ->
                body.add(set.variable() + " = " + set.variable() + ".and(" + OperationText.lanes(Kind.MASK, set.value())
                        + ");");
            case LaneIf choice -> body.block("if (" + choice.mask() + ".anyTrue())", () -> write(choice.body()));
            case UniformIf choice -> {
                if (!choice.then().list().isEmpty()) {
                    body.block("if (" + choice.condition() + ")", () -> write(choice.then()));
                }
                if (!choice.otherwise().list().isEmpty()) {
                    body.block("if (!(" + choice.condition() + "))", () -> write(choice.otherwise()));
                }
            }
            case LaneLoop loop -> writeLoop(loop);
            case UniformLoop loop ->
                body.block(
                        "for (int " + loop.index() + " = " + loop.from() + "; " + loop.condition() + "; " + loop.index()
                                + " = " + loop.next() + ")",
                        () -> write(loop.body()));
        }
    }

    private static String masked(MaskedAssignment set) {
        Variable variable = set.variable();
        String mask = set.mask().toString();
        return switch (variable.kind) {
            case FLOAT -> variable + " = " + variable + ".blend(" + OperationText.any(set.value()) + ", " + mask + ");";
            case INT ->
                variable + " = " + variable + ".blend(" + OperationText.any(set.value()) + ", " + mask
                        + ".cast(INTS));";
            case MASK ->
                variable + " = " + variable + ".andNot(" + mask + ").or(" + OperationText.lanes(Kind.MASK, set.value())
                        + ".and(" + mask + "));";
        };
    }

    private void writeLoop(LaneLoop loop) {
        Set<Variable> outer = known;
        known = new HashSet<>(known);
        body.block("while (true)", () -> {
            write(loop.condition().list());
            body.block("if (!" + loop.mask() + ".anyTrue())", () -> body.add("break;"));
            write(loop.body().list());
        });
        known = outer;
    }
}
