package dev.twister.engine.vector;

/**
 * The steps of walks through the hierarchy, of one packet each, which are not inlined for the reason that {@link Stages} has.
 */
final class LaneSteps {
    private LaneSteps() {}

    static long startPacket(Tile tile, int at) {
        return PacketHits.start(tile.values, at);
    }

    static long gather(Tile tile, int at, int goesOn) {
        return PacketHits.gather(tile.values, at, goesOn);
    }

    static void meetSpheres(Tile tile, Drawing drawing, int at, int block, long wanted) {
        PacketHits.meet(tile.values, at, drawing.hierarchy.spheres.values, block, wanted);
    }

    static long farthest(Tile tile, int at) {
        return PacketHits.farthest(tile.values, at);
    }

    static void findBetweens(Tile tile, int at, int count) {
        ShadowCandidates.betweens(tile.values, at, tile.near, count, tile.shadow.betweens);
    }

    static long isOutside(Tile tile, Drawing drawing, int at, int body) {
        return ShadowCandidates.isOutside(tile.values, at, drawing.bodies, body);
    }

    static long hidesDisc(Tile tile, Drawing drawing, int at, int body) {
        return ShadowCandidates.hidesDisc(tile.values, at, drawing.bodies, body);
    }

    static long finishPacket(Tile tile, int at) {
        return ShadowCandidates.finish(tile.values, at, tile.shadow);
    }

    static long open(Tile tile, int at) {
        return ShadowCandidates.open(tile.values, at);
    }

    static long openOnGround(Tile tile, int at) {
        return ShadowCandidates.openOnGround(tile.values, at);
    }

    static void narrow(Tile tile, int at, int lanes) {
        ShadowCandidates.narrow(tile.values, at, lanes);
    }

    static void meetLight(Tile tile, Drawing drawing, int at) {
        PacketHits.meet(tile.values, at, drawing.light.values, SphereColumns.FIRST, 1);
    }

    static void boundTogether(Tile tile, int first, int end, int column) {
        tile.beam.bound(tile.values, tile.together.places, first, end, column, Tile.TOGETHER);
    }

    static void boundOpen(Tile tile, int number, int column) {
        tile.beam.bound(tile.values, tile.shadows.places, number, number + 1, column, Tile.SHADOW_OPEN);
    }

    static int listRootChildren(WideHierarchy hierarchy, PacketBeams beams, int count, int[] links) {
        return RootChildren.list(hierarchy, beams, count, links);
    }
}
