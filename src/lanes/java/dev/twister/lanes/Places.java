package dev.twister.lanes;

import dev.twister.lanes.Statement.PathStore;
import dev.twister.lanes.Statement.ScratchStore;
import dev.twister.lanes.Value.Constant;
import dev.twister.lanes.Value.Lanes;
import dev.twister.lanes.Value.Sum;
import dev.twister.lanes.Value.Uniform;

/** Loads and stores of the kernel's arrays: each lane has a path and a scratch of its own, all share the others. */
record Places(Builder builder) {
    static final String PATH = "path";
    private static final String SCRATCH = "scratch";

    Value load(String array, Value place) {
        return switch (array) {
            case PATH -> loadPath(path(place));
            case SCRATCH -> {
                if (!place.varies()) {
                    yield builder.load("scratchAt", place.text());
                }
                Sum at = scratch(place);
                yield builder.load("scratch", at.variable(), at.constant());
            }
            default -> {
                if (!place.varies()) {
                    yield new Uniform(array + "[" + place.text() + "]", Kind.FLOAT);
                }
                Sum at = builder.sum(place);
                yield builder.add(Kind.FLOAT, "gather", array, builder.safe(at.variable()), at.constant());
            }
        };
    }

    private Value loadPath(int place) {
        return builder.scope.path.computeIfAbsent(place, _ -> builder.load("path", place));
    }

    private static int path(Value place) {
        if (place instanceof Constant(Integer constant)) {
            return constant;
        }
        throw new Refusal("the path at a place that is not a constant");
    }

    /** Places in the scratches of all lanes, which lie side by side. */
    private Sum scratch(Value place) {
        Sum at = builder.sum(place);
        Lanes ofLanes = builder.add(Kind.INT, "scratchPlace", new Lanes(at.variable()));
        return new Sum(builder.safe(ofLanes.variable()), at.constant());
    }

    void store(String array, Value place, Value value) {
        Value number = builder.asFloat(value);
        switch (array) {
            case PATH -> {
                int at = path(place);
                builder.block.list().add(new PathStore(at, number, builder.mask(), builder.source));
                builder.scope.store(at, number);
            }
            case SCRATCH -> {
                Sum at = place.varies() ? scratch(place) : null;
                String text = at == null ? place.text() : Integer.toString(at.constant());
                Variable lanes = at == null ? null : at.variable();
                builder.block.list().add(new ScratchStore(lanes, text, number, builder.mask(), builder.source));
            }
            default -> throw new Refusal("a store to " + array + ", which all lanes share");
        }
    }
}
