package dev.twister.engine.vector;

/**
 * The steps of walks through the hierarchy, behind an interface for the reason that {@link Stage} has: all are called from
 * one place, so that the compiler inlines none into the walks, where vectors would become objects.
 */
final class LaneSteps {
    static final int PASS_BOXES = 0;
    static final int TOUCH_SPHERES = 1;
    static final int HOLD_RAYS = 2;
    static final int HOLD_ORIGINS = 3;
    static final int HOLD_POINTS = 4;
    static final int START_PACKET = 5;
    static final int MEET_SPHERE = 6;
    static final int FARTHEST = 7;
    static final int MEET_SPHERES = 8;
    static final int BETWEEN = 9;
    static final int OUTSIDE = 10;
    static final int HIDES_DISC = 11;
    static final int OPEN_LANES = 12;
    static final int FINISH_PACKET = 13;
    static final int BLOCKS = 14;
    static final int CROSS_BOXES = 15;

    /** The steps, by the numbers above; an array, so that the compiler does not know which it calls. */
    private static final LaneStep[] STEPS = {
        (tile, drawing, hull, at, item) ->
                hull.passing(drawing.hierarchy.boxes, item * WideHierarchy.BOX_STRIDE, tile.descent.childEntries),
        (tile, drawing, hull, at, item) -> hull.touching(
                drawing.hierarchy.x, drawing.hierarchy.y, drawing.hierarchy.z, drawing.hierarchy.radius, item),
        (tile, drawing, hull, at, item) -> {
            hull.holdRays(tile, tile.packet);
            return 0;
        },
        (tile, drawing, hull, at, item) -> {
            hull.startAround(tile, tile.packet, Tile.ORIGIN_X, Tile.THROUGHPUT);
            return 0;
        },
        (tile, drawing, hull, at, item) -> {
            hull.startAround(tile, tile.packet, Tile.POINT_X, Tile.SHADOW_OPEN);
            return 0;
        },
        (tile, drawing, hull, at, item) -> {
            PacketHits.start(tile.values, at, drawing.bodies);
            return 0;
        },
        (tile, drawing, hull, at, item) -> {
            PacketHits.meet(tile.values, at, drawing.hierarchy, item);
            return 0;
        },
        (tile, drawing, hull, at, item) -> PacketHits.farthest(tile.values, at),
        (tile, drawing, hull, at, item) ->
                PacketHits.near(tile.values, at, drawing.hierarchy, item, tile.descent.childEntries),
        (tile, drawing, hull, at, item) -> ShadowCandidates.between(tile.values, at, drawing.bodies, item),
        (tile, drawing, hull, at, item) -> ShadowCandidates.isOutside(tile.values, at, drawing.bodies, item),
        (tile, drawing, hull, at, item) -> ShadowCandidates.hidesDisc(tile.values, at, drawing.bodies, item),
        (tile, drawing, hull, at, item) -> ShadowCandidates.open(tile.values, at),
        (tile, drawing, hull, at, item) -> ShadowCandidates.finish(tile.values, at, tile.shadow),
        (tile, drawing, hull, at, item) -> LoneShadows.blocks(tile.shadow.lone, item, drawing, at),
        (tile, drawing, hull, at, item) ->
                hull.crossing(drawing.hierarchy.boxes, item * WideHierarchy.BOX_STRIDE, tile.descent.childEntries),
    };

    private LaneSteps() {}

    /** Does the step of that number. */
    static long run(int step, Tile tile, Drawing drawing, Hull hull, int at, int item) {
        return STEPS[step].run(tile, drawing, hull, at, item);
    }
}
