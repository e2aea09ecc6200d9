package dev.twister.engine.vector;

import dev.twister.kernel.Layout;

/** Draws tiles, stage by stage; one for each thread. */
final class TileRenderer {
    private static final Stage[] START = {
        (tile, drawing) -> ViewRays.start(tile, drawing),
        (tile, drawing) -> ViewRays.place(tile, drawing.input.camera()),
    };

    private static final Stage[] HOLD_VIEW = {
        (tile, drawing) -> ViewRays.bound(tile, drawing),
    };

    private static final Stage[] CULL = {
        (tile, drawing) -> tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates),
    };

    private static final Stage[] NOTHING_HIT = {
        (tile, drawing) -> HitSorting.sortSkies(tile),
    };

    private static final Stage[] NEAREST_OF_FEW = {
        (tile, drawing) -> NearestSphere.find(tile, drawing.bodies, tile.candidates),
    };

    private static final Stage[] NEAREST_OF_MANY = {
        (tile, drawing) -> PacketHits.find(tile, drawing),
    };

    private static final Stage[] HIT = {
        (tile, drawing) -> GroundHit.find(tile, drawing.planeHeight, drawing.planeHalfSide),
        (tile, drawing) -> HitSorting.sort(tile),
    };

    private static final Stage[] LIGHT = {
        (tile, drawing) -> LightHit.add(tile, drawing.bodies),
    };

    private static final Stage[] SKY = {
        (tile, drawing) -> SkyDirection.findRatios(tile),
        (tile, drawing) -> SkyDirection.findArcTangents(tile, Tile.SKY_TO_RIGHT),
        (tile, drawing) -> SkyDirection.findArcTangents(tile, Tile.SKY_TO_BOTTOM),
        (tile, drawing) -> SkyDirection.findColumns(tile, drawing.sky),
        (tile, drawing) -> SkyDirection.findRows(tile, drawing.sky),
    };

    private static final Stage[] SORT_SKY = {
        (tile, drawing) -> SkyPatches.sort(tile),
    };

    private static final Stage[] SKY_PATCHES = {
        (tile, drawing) -> SkyPatches.add(tile, drawing.sky),
    };

    private static final Stage[] SORT_SKY_IN_ROWS = {
        (tile, drawing) -> SkyRows.sort(tile),
    };

    private static final Stage[] SKY_ROWS = {
        (tile, drawing) -> SkyRows.add(tile, drawing.sky),
    };

    private static final Stage[] SCATTERED_SKY = {
        (tile, drawing) -> SkyRadiance.listPixels(tile),
        (tile, drawing) -> SkyRadiance.findTexels(tile, drawing.sky),
        (tile, drawing) -> SkyRadiance.fetch(tile, drawing.sky),
        (tile, drawing) -> SkyRadiance.unpack(tile, drawing.sky),
        (tile, drawing) -> SkyRadiance.add(tile),
    };

    private static final Stage[] GROUND = {
        (tile, drawing) -> GroundSurface.findPoints(tile, drawing),
        (tile, drawing) -> GroundSurface.findColors(tile, drawing),
    };

    private static final Stage[] SPHERES = {
        (tile, drawing) -> SphereSurface.fetch(tile, drawing),
        (tile, drawing) -> SphereSurface.findOffsets(tile),
        (tile, drawing) -> SphereSurface.findPoints(tile),
    };

    private static final Stage[] SURFACE = {
        (tile, drawing) -> LightDirection.find(tile, drawing.bodies),
        (tile, drawing) -> LightDirection.sort(tile, drawing.ambient),
        (tile, drawing) -> Shadows.find(tile, drawing),
        (tile, drawing) -> Highlight.findCosines(tile),
        (tile, drawing) -> Highlight.sort(tile),
        (tile, drawing) -> Highlight.raise(tile, drawing),
        (tile, drawing) -> Bounce.shade(tile, drawing.bodies, drawing.ambient),
        (tile, drawing) -> Bounce.reflect(tile),
        (tile, drawing) -> Bounce.leave(tile),
    };

    private static final Stage[] HOLD_ANEW = {
        (tile, drawing) -> tile.rays.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT),
        (tile, drawing) -> tile.rays.holdRays(tile, tile.live),
    };

    private static final Stage[] FINISH_PIXELS = {
        (tile, drawing) -> ToneStage.map(tile, drawing.input.rayTracingProperties(), drawing.pixelSamples),
        (tile, drawing) -> ToneStage.pack(tile),
        (tile, drawing) -> TileOutput.write(tile, drawing.frame),
    };

    private static final Stage[] FINISH_RADIANCE = {
        (tile, drawing) -> TileOutput.writeLinear(tile, drawing.frame, 1f / drawing.pixelSamples),
    };

    private final Tile tile = new Tile();

    /** Makes room for a frame's bodies. */
    void reserve(int bodies) {
        tile.candidates.reserve(bodies);
        tile.shadow.reserveBodies(bodies);
        tile.near.reserveList(Shadows.MOST_NEAR + Lanes.COUNT);
    }

    /** Draws the tile of that number, counted along the rows of tiles from the top left. */
    void draw(Drawing drawing, int number) {
        tile.left = number % drawing.tilesAcross() * Tile.SIDE;
        tile.top = number / drawing.tilesAcross() * Tile.SIDE;
        listInside(drawing);
        ViewRays.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            tile.sample = sample;
            if (sample > 0) {
                // Following the last sample's rays has emptied it.
                listInside(drawing);
            }
            Stage.runAll(START, tile, drawing);
            follow(drawing);
        }
        Stage.runAll(drawing.frame.isLinear() ? FINISH_RADIANCE : FINISH_PIXELS, tile, drawing);
    }

    /** Lists the packets with a pixel of the frame in them: all of most tiles. */
    private void listInside(Drawing drawing) {
        if (tile.left + Tile.SIDE <= drawing.width && tile.top + Tile.SIDE <= drawing.rows) {
            tile.live.addAll();
        } else {
            tile.live.clear();
            for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
                if (tile.left + Tile.column(at) < drawing.width && tile.top + Tile.row(at) < drawing.rows) {
                    tile.live.add(at);
                }
            }
        }
    }

    private void follow(Drawing drawing) {
        for (int bounce = 0; bounce <= drawing.bounceLimit && tile.live.count > 0; bounce++) {
            tile.last = bounce == drawing.bounceLimit;
            if (drawing.crowded) {
                Stage.runAll(NEAREST_OF_MANY, tile, drawing);
                Stage.runAll(HIT, tile, drawing);
            } else {
                meetFew(drawing, bounce);
            }
            Stage.runFor(tile.lights.count, LIGHT, tile, drawing);
            if (tile.skies.count > 0) {
                Stage.runAll(SKY, tile, drawing);
                boolean inRows = SkyRows.FIT && drawing.sky.halved;
                Stage.runAll(inRows ? SORT_SKY_IN_ROWS : SORT_SKY, tile, drawing);
                Stage.runFor(tile.skyPatches.count, inRows ? SKY_ROWS : SKY_PATCHES, tile, drawing);
                Stage.runFor(tile.scatteredSkies.count, SCATTERED_SKY, tile, drawing);
            }
            Stage.runFor(tile.grounds.count, GROUND, tile, drawing);
            Stage.runFor(tile.spheres.count, SPHERES, tile, drawing);
            Stage.runFor(tile.surfaces.count, SURFACE, tile, drawing);
            if (tile.surfaces.count == 0) {
                tile.live.clear();
            }
        }
    }

    /** Sorts the live rays by what they meet, where the hulls of all rays tell what cannot be met. */
    private void meetFew(Drawing drawing, int bounce) {
        boolean offPlane = bounce == 1 && tile.spheres.count == 0;
        if (offPlane) {
            tile.rays.mirror(drawing.planeHeight);
        } else {
            Stage.runAll(bounce == 0 ? HOLD_VIEW : HOLD_ANEW, tile, drawing);
        }
        Stage.runAll(CULL, tile, drawing);
        if (tile.candidates.count == 0 && (offPlane || tile.rays.rises(drawing.planeHeight))) {
            Stage.runAll(NOTHING_HIT, tile, drawing);
        } else {
            Stage.runAll(NEAREST_OF_FEW, tile, drawing);
            Stage.runAll(HIT, tile, drawing);
        }
    }
}
