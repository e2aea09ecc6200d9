package dev.twister.engine.vector;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.Shadows;
import dev.twister.engine.vector.shortcut.GroundAlone;
import dev.twister.engine.vector.shortcut.OpenGround;
import dev.twister.engine.vector.shortcut.TileShortcuts;
import dev.twister.engine.vector.step.BranchLanes;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.engine.vector.step.GroundSurface;
import dev.twister.engine.vector.step.Highlight;
import dev.twister.engine.vector.step.ScatterLanes;
import dev.twister.engine.vector.step.TileOutput;
import dev.twister.kernel.Variant;

/** Renders tiles step by step. Each thread has its own instance. */
final class TileRenderer {
    private final TileMemory bench = new TileMemory();
    private final Tile tile = bench.tile;
    private final BounceRenderer bounces = new BounceRenderer(bench);
    private final PathTile paths = new PathTile(bench, bounces);
    private final PacketPaths packetPaths = new PacketPaths(bench, bounces);
    private final PathRehearsal rehearsal;
    private final boolean rehearses;

    /**
     * One thread's renderer.
     *
     * @param rehearsal of all threads
     * @param rehearses whether this one rehearses
     */
    TileRenderer(PathRehearsal rehearsal, boolean rehearses) {
        this.rehearsal = rehearsal;
        this.rehearses = rehearses;
    }

    /** Prepares for a frame. */
    void start(Drawing drawing) {
        bench.start(drawing);
    }

    /** Renders a tile, unless the frame is stopped meanwhile; tiles are numbered row by row from the top left. */
    void draw(Drawing drawing, int number) {
        if (drawing.input.isWanted(number) && !drawing.stop.isAsked()) {
            drawWanted(drawing, number);
        }
    }

    private void drawWanted(Drawing drawing, int number) {
        tile.left = number % drawing.tilesAcross() * Tile.SIDE;
        tile.top = number / drawing.tilesAcross() * Tile.SIDE;
        TileOutput.approachNext(tile, drawing.frame);
        if (drawing.declined.isFrame()) {
            bench.handover.drawTile(tile, drawing);
            return;
        }
        if (drawing.input.tracesPaths()) {
            drawPaths(drawing);
            return;
        }
        bench.wholeTiles.rehearse(drawing);
        TileShortcuts.Way way = bench.choices.choose(tile, drawing);
        switch (way) {
            case SKY -> TileOutput.finish(drawing, bench.wholeTiles.addSky(tile, drawing));
            case OPEN_GROUND -> TileOutput.finish(drawing, bench.wholeTiles.addOpenGround(tile, drawing));
            case LIT_GROUND, GROUND, ANY -> drawSamples(drawing, way);
        }
    }

    private void drawPaths(Drawing drawing) {
        boolean made = (drawing.input.variant(false) & Variant.FINISH) == 0;
        if (made && rehearsal.isOver()) {
            paths.draw(drawing);
        } else {
            long start = PathRehearsal.clockNanos();
            if (drawing.declined.areKernelPaths()) {
                bench.handover.drawTile(tile, drawing);
            } else {
                packetPaths.draw(drawing);
            }
            if (made && rehearses) {
                rehearsal.goOn(paths, drawing, tile, PathRehearsal.clockNanos() - start);
            }
        }
    }

    private void drawSamples(Drawing drawing, TileShortcuts.Way way) {
        CameraLanes.listInside(tile, drawing);
        CameraLanes.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples && !drawing.stop.isAsked(); sample++) {
            startSample(drawing, sample);
            switch (way) {
                case LIT_GROUND -> OpenGround.addAndLeave(drawing, tile);
                case GROUND -> shadeGround(drawing);
                default -> CameraLanes.startRays(drawing, tile);
            }
            follow(drawing, way == TileShortcuts.Way.ANY ? 0 : 1);
        }
        if (!drawing.stop.isAsked()) {
            TileOutput.finish(drawing, tile);
        }
    }

    private void startSample(Drawing drawing, int sample) {
        tile.sample = sample;
        if (sample > 0) {
            // The previous sample has changed both lists.
            CameraLanes.listInside(tile, drawing);
            if (!drawing.crowded && !drawing.lens) {
                bench.choices.cullViewRays(drawing, tile);
            }
        }
    }

    /** Follows the live rays from the given bounce to their ends. */
    private void follow(Drawing drawing, int firstBounce) {
        for (int bounce = firstBounce;
                bounce <= drawing.bounceLimit && tile.live.count > 0 && !drawing.stop.isAsked();
                bounce++) {
            boolean offPlane = bounce == 1 && tile.spheres.count == 0 && drawing.looks.plainPlane && !drawing.lens;
            bounces.follow(drawing, tile, bounce, offPlane);
        }
        if (drawing.looks.isBranching()) {
            followWaiting(drawing);
        }
    }

    /** Follows the waiting branch rays, including those added meanwhile, to their ends. */
    private void followWaiting(Drawing drawing) {
        Tile rays = bench.branches;
        rays.moveTo(tile);
        rays.sample = tile.sample;
        for (int bounce = nextWaiting(drawing); bounce >= 0; bounce = nextWaiting(drawing)) {
            BranchLanes.resume(rays, bench.waiting, bounce);
            bounces.follow(drawing, rays, bounce, false);
            BranchLanes.add(rays, tile);
        }
    }

    private int nextWaiting(Drawing drawing) {
        if (drawing.stop.isAsked()) {
            bench.waiting.clear();
        }
        return bench.waiting.next();
    }

    /** Shades a tile whose view rays all hit the ground. */
    private void shadeGround(Drawing drawing) {
        tile.last = drawing.bounceLimit == 0;
        CameraLanes.aim(tile, drawing);
        GroundAlone.meet(tile, drawing);
        GroundSurface.findColors(tile, drawing);
        GroundAlone.findLight(tile, drawing);
        Shadows.findOnGround(tile, drawing, bench.shadows, bench.choices.ground());
        GroundAlone.findHighlight(tile, drawing);
        Highlight.raise(tile);
        ScatterLanes.shade(tile, drawing);
        GroundAlone.leave(tile);
    }
}
