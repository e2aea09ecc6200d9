package dev.twister.engine.vector;

/**
 * The steps of walks through the hierarchy, behind an interface for the reason that {@link Stage} has: all are called from
 * one place, so that the compiler inlines none into the walks, where vectors would become objects.
 */
final class LaneSteps {
    static final int START_PACKET = 0;
    static final int GATHER = 1;
    static final int MEET_SPHERES = 2;
    static final int FARTHEST = 3;
    static final int BETWEEN = 4;
    static final int OUTSIDE = 5;
    static final int HIDES_DISC = 6;
    static final int FINISH_PACKET = 7;
    static final int OPEN = 8;
    static final int OPEN_ON_GROUND = 9;
    static final int NARROW = 10;
    static final int MEET_LIGHT = 11;
    static final int BOUND_TOGETHER = 12;
    static final int BOUND_OPEN = 13;

    /** The steps, by the numbers above; an array, so that the compiler does not know which it calls. */
    private static final LaneStep[] STEPS = {
        (tile, drawing, at, item) -> PacketHits.start(tile.values, at),
        (tile, drawing, at, item) -> PacketHits.gather(tile.values, at, item),
        (tile, drawing, at, item) -> {
            PacketHits.meet(tile.values, at, drawing.hierarchy.spheres.values, item, tile.spheresMet);
            return 0;
        },
        (tile, drawing, at, item) -> PacketHits.farthest(tile.values, at),
        (tile, drawing, at, item) -> {
            ShadowCandidates.betweens(tile.values, at, tile.near, item, tile.shadow.betweens);
            return 0;
        },
        (tile, drawing, at, item) -> ShadowCandidates.isOutside(tile.values, at, drawing.bodies, item),
        (tile, drawing, at, item) -> ShadowCandidates.hidesDisc(tile.values, at, drawing.bodies, item),
        (tile, drawing, at, item) -> ShadowCandidates.finish(tile.values, at, tile.shadow),
        (tile, drawing, at, item) -> ShadowCandidates.open(tile.values, at),
        (tile, drawing, at, item) -> ShadowCandidates.openOnGround(tile.values, at),
        (tile, drawing, at, item) -> {
            ShadowCandidates.narrow(tile.values, at, item);
            return 0;
        },
        (tile, drawing, at, item) -> {
            PacketHits.meet(tile.values, at, drawing.light.values, SphereColumns.FIRST, 1);
            return 0;
        },
        (tile, drawing, at, item) -> {
            tile.beam.bound(tile.values, at + item, at + Tile.TOGETHER);
            return 0;
        },
        (tile, drawing, at, item) -> {
            tile.beam.bound(tile.values, at + item, at + Tile.SHADOW_OPEN);
            return 0;
        },
    };

    private LaneSteps() {}

    /** Does the step of that number. */
    static long run(int step, Tile tile, Drawing drawing, int at, int item) {
        return STEPS[step].run(tile, drawing, at, item);
    }
}
