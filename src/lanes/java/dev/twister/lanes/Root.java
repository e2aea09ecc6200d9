package dev.twister.lanes;

import com.sun.source.tree.VariableTree;
import dev.twister.lanes.Statement.Assignment;
import dev.twister.lanes.Value.Array;
import dev.twister.lanes.Value.Lanes;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Makes the class of one of the kernel's methods. Its int parameters are the int columns from 1 on, its float
 * parameters those after the path's floats and the column of a float that it returns; an int that it returns is column
 * 0. The lanes that run are mask 0.
 */
final class Root {
    /** Largest weight of a unit. */
    private static final int UNIT = 200;

    /** Largest weight of an {@code if} that becomes choices. */
    private static final int FLAT = 40;

    /** The class's Java. */
    final String text;

    final int floats;
    final int ints;
    final int masks;
    final int lists;

    /** Places of the path's floats that are read before they are stored. */
    final Set<Integer> state;

    /**
     * Makes a class.
     *
     * @param pathLength number of the path's floats
     * @param variants numbers that a picture's properties may be
     */
    Root(
            Sources sources,
            String packageName,
            String className,
            Sources.Method method,
            int pathLength,
            List<Integer> variants) {
        Builder builder = new Builder();
        Map<Kind, Integer> pinned = new EnumMap<>(Map.of(Kind.FLOAT, pathLength + 1, Kind.INT, 1, Kind.MASK, 1));
        List<Value> arguments = new ArrayList<>();
        for (VariableTree parameter : method.tree().getParameters()) {
            String name = parameter.getName().toString();
            String type = parameter.getType().toString();
            if (name.equals("variant")) {
                arguments.add(Uniforms.variant(name, variants));
            } else if (type.endsWith("[]")) {
                arguments.add(new Array(name));
            } else {
                Kind kind = type.equals("float") ? Kind.FLOAT : Kind.INT;
                int column = pinned.merge(kind, 1, Integer::sum) - 1;
                arguments.add(new Lanes(builder.variable(kind, false).pinnedAt(column)));
            }
        }
        Variable active = builder.variable(Kind.MASK, false).pinnedAt(0);
        builder.within(active, () -> {
            run(sources, builder, method, arguments, pathLength);
            return active;
        });
        Unused.removeFrom(builder.block);
        state = PathState.of(builder.block, active);
        Plan plan = new Plan(builder.block, UNIT);
        Lifetimes lifetimes = new Lifetimes(plan, builder.variables, pinned);
        ClassText written = new ClassText(packageName, className, method.name(), plan, lifetimes);
        text = written.toString();
        floats = lifetimes.columns(Kind.FLOAT);
        ints = lifetimes.columns(Kind.INT);
        masks = lifetimes.columns(Kind.MASK);
        lists = written.lists();
    }

    private static void run(
            Sources sources, Builder builder, Sources.Method method, List<Value> arguments, int pathLength) {
        Value result = new Statements(sources, builder, FLAT).call(method, arguments);
        if (result != null) {
            Kind kind = result.kind() == Kind.FLOAT ? Kind.FLOAT : Kind.INT;
            Variable column = builder.variable(kind, true).pinnedAt(kind == Kind.FLOAT ? pathLength : 0);
            builder.block.list().add(new Assignment(column, builder.as(kind, result)));
        }
    }
}
