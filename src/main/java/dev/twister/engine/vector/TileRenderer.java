package dev.twister.engine.vector;

import dev.twister.engine.vector.crowd.PacketHits;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.Shadows;
import dev.twister.engine.vector.shortcut.Choices;
import dev.twister.engine.vector.shortcut.GroundAlone;
import dev.twister.engine.vector.shortcut.OpenGround;
import dev.twister.engine.vector.shortcut.TileSky;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.engine.vector.step.FacetLanes;
import dev.twister.engine.vector.step.GroundHit;
import dev.twister.engine.vector.step.GroundSurface;
import dev.twister.engine.vector.step.Highlight;
import dev.twister.engine.vector.step.HitSorting;
import dev.twister.engine.vector.step.LightDirection;
import dev.twister.engine.vector.step.LightHit;
import dev.twister.engine.vector.step.MaterialLanes;
import dev.twister.engine.vector.step.NearestSphere;
import dev.twister.engine.vector.step.ScatterLanes;
import dev.twister.engine.vector.step.SkyDirection;
import dev.twister.engine.vector.step.SphereSurface;
import dev.twister.engine.vector.step.TextureLanes;
import dev.twister.engine.vector.step.TileOutput;

/** Draws tiles, step by step; one for each thread. */
final class TileRenderer {
    private final Workbench bench = new Workbench();
    private final Tile tile = bench.tile;

    /** Prepares for a frame. */
    void start(Drawing drawing) {
        bench.start(drawing);
    }

    /** Draws the tile of that number, counted along the rows of tiles from the top left. */
    void draw(Drawing drawing, int number) {
        tile.left = number % drawing.tilesAcross() * Tile.SIDE;
        tile.top = number / drawing.tilesAcross() * Tile.SIDE;
        TileOutput.approachNext(tile, drawing.frame);
        if (drawing.declined.isFrame()) {
            bench.handover.drawTile(tile, drawing);
            return;
        }
        bench.wholeTiles.rehearse(drawing);
        Choices.Way way = bench.choices.choose(tile, drawing);
        switch (way) {
            case SKY -> TileOutput.finish(drawing, bench.wholeTiles.addSky(tile, drawing));
            case OPEN_GROUND -> TileOutput.finish(drawing, bench.wholeTiles.addOpenGround(tile, drawing));
            case LIT_GROUND, GROUND, ANY -> drawSamples(drawing, way);
        }
    }

    private void drawSamples(Drawing drawing, Choices.Way way) {
        CameraLanes.listInside(tile, drawing);
        CameraLanes.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            startSample(drawing, sample);
            switch (way) {
                case LIT_GROUND -> OpenGround.addAndLeave(drawing, tile);
                case GROUND -> shadeGround(drawing);
                default -> CameraLanes.startRays(drawing, tile);
            }
            follow(drawing, way == Choices.Way.ANY ? 0 : 1);
        }
        TileOutput.finish(drawing, tile);
    }

    private void startSample(Drawing drawing, int sample) {
        tile.sample = sample;
        if (sample > 0) {
            // Following the last sample's rays has changed both.
            CameraLanes.listInside(tile, drawing);
            if (!drawing.crowded) {
                bench.choices.cullViewRays(drawing, tile);
            }
        }
    }

    /** Follows the live rays, which have met and left so many surfaces, to their ends. */
    private void follow(Drawing drawing, int firstBounce) {
        for (int bounce = firstBounce; bounce <= drawing.bounceLimit && tile.live.count > 0; bounce++) {
            tile.last = bounce == drawing.bounceLimit;
            boolean offPlane = bounce == 1 && tile.spheres.count == 0 && drawing.looks.plainPlane;
            findHits(drawing, bounce, offPlane);
            if (drawing.declined.isAnyBody()) {
                bench.handover.endAtHits(tile, drawing, bounce);
            }
            if (tile.lights.count > 0) {
                LightHit.add(tile, drawing.bodies);
            }
            if (tile.skies.count > 0) {
                addSky(drawing, bounce == 0 || offPlane, offPlane);
            }
            if (tile.grounds.count > 0) {
                GroundSurface.find(drawing, tile);
            }
            if (tile.spheres.count > 0) {
                SphereSurface.find(drawing, tile);
            }
            if (drawing.looks.isAny()) {
                MaterialLanes.find(drawing, tile);
                if (drawing.looks.textured) {
                    TextureLanes.multiply(drawing, tile);
                }
            }
            if (tile.surfaces.count > 0) {
                shade(drawing, bounce);
            } else {
                tile.live.clear();
            }
        }
    }

    /** Sorts the live rays by what they meet. */
    private void findHits(Drawing drawing, int bounce, boolean offPlane) {
        boolean rise = offPlane;
        if (drawing.crowded) {
            PacketHits.find(tile, drawing, bench.walks);
        } else {
            rise = bench.choices.cull(tile, drawing, bounce, offPlane);
            if (rise && tile.candidates.count == 0) {
                HitSorting.sortSkies(tile);
                return;
            }
            NearestSphere.find(tile, drawing.bodies, tile.candidates);
        }
        if (!rise) {
            GroundHit.find(tile, drawing);
        }
        HitSorting.sort(tile);
    }

    private void addSky(Drawing drawing, boolean ofViewRays, boolean mirrored) {
        if (ofViewRays && bench.sky.pays(tile, drawing)) {
            bench.sky.addCharted(tile, drawing, mirrored);
        } else {
            SkyDirection.find(drawing.sky, tile);
            TileSky.add(tile, drawing);
        }
    }

    /** Adds what the surfaces send towards the eye, and starts the rays that go on. */
    private void shade(Drawing drawing, int bounce) {
        LightDirection.find(drawing, tile);
        if (drawing.declined.isAnyBody() || drawing.planeMayShade) {
            bench.handover.endInShadows(tile, drawing, bounce);
        }
        Shadows.find(tile, drawing, bench.shadows);
        Highlight.find(tile);
        ScatterLanes.shade(tile, drawing);
        if (drawing.looks.rough && tile.rough.count > 0 && tile.live.count > 0) {
            FacetLanes.find(drawing, tile, tile.live, bounce);
            FacetLanes.reflect(tile, tile.live);
        } else {
            ScatterLanes.reflect(tile);
        }
        ScatterLanes.leave(tile);
    }

    /** The same from the view rays on, which all meet the ground. */
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
