package dev.twister.engine.vector;

import dev.twister.kernel.Layout;

/** Draws tiles, stage by stage; one for each thread. */
final class TileRenderer {
    private final Tile tile = new Tile();
    private final Hull hull = new Hull();
    private final BodyList candidates = new BodyList();
    private final Shadows shadows = new Shadows();

    /** Makes room for a frame's bodies. */
    void reserve(int bodies) {
        candidates.reserve(bodies);
        shadows.reserve(bodies);
    }

    void draw(Drawing drawing, int number) {
        int left = number % drawing.tilesAcross() * Tile.SIDE;
        int top = number / drawing.tilesAcross() * Tile.SIDE;
        listInside(drawing, left, top);
        ViewRays.blacken(tile);
        float[] offsets = drawing.input.pixelOffsets();
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            listInside(drawing, left, top);
            float x = left + offsets[2 * sample];
            float y = drawing.input.firstRow() + top + offsets[2 * sample + 1];
            ViewRays.start(tile, drawing, x, y);
            follow(drawing);
        }
        finish(drawing, left, top);
    }

    /** Lists the packets with a pixel of the frame in them. */
    private void listInside(Drawing drawing, int left, int top) {
        tile.live.clear();
        for (int at = 0; at < Tile.SIZE; at += Lanes.COUNT) {
            if (left + Tile.column(at) < drawing.width && top + Tile.row(at) < drawing.rows) {
                tile.live.add(at);
            }
        }
    }

    private void follow(Drawing drawing) {
        float[] camera = drawing.input.camera();
        ViewRays.place(tile, camera);
        hull.startAt(
                camera[Layout.CAMERA_POSITION], camera[Layout.CAMERA_POSITION + 1], camera[Layout.CAMERA_POSITION + 2]);
        for (int bounce = 0; bounce <= drawing.bounceLimit && tile.live.count > 0; bounce++) {
            if (bounce > 0) {
                hull.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT);
            }
            hull.holdRays(tile);
            hull.cull(drawing.bodies, Layout.LIGHT, candidates);
            NearestSphere.find(tile, drawing.bodies, candidates);
            GroundHit.find(tile, drawing.planeHeight, drawing.planeHalfSide);
            HitSorting.sort(tile, drawing.bodies);
            addSky(drawing);
            addSurfaces(drawing, bounce == drawing.bounceLimit);
        }
    }

    private void addSky(Drawing drawing) {
        SkyDirection.findAzimuthRatios(tile);
        SkyDirection.findElevationRatios(tile);
        SkyDirection.findArcTangents(tile, Tile.SKY_TO_RIGHT);
        SkyDirection.findArcTangents(tile, Tile.SKY_TO_BOTTOM);
        SkyDirection.findAzimuths(tile);
        SkyDirection.findElevations(tile);
        SkyDirection.findTexels(tile, drawing.sky);
        SkyRadiance.blend(tile, drawing.sky);
        SkyRadiance.add(tile);
    }

    private void addSurfaces(Drawing drawing, boolean last) {
        GroundSurface.findPoints(tile, drawing);
        GroundSurface.findColors(tile, drawing);
        SphereSurface.fetch(tile, drawing.bodies);
        SphereSurface.findOffsets(tile);
        SphereSurface.findPoints(tile);
        LightDirection.find(tile, drawing.bodies);
        LightDirection.sort(tile, drawing.ambient);
        shadows.find(tile, drawing);
        Highlight.findCosines(tile);
        Highlight.findStrengths(tile);
        Bounce.shade(tile, drawing.bodies, drawing.ambient, last);
        Bounce.reflect(tile);
        Bounce.leave(tile);
    }

    private void finish(Drawing drawing, int left, int top) {
        float average = 1f / drawing.pixelSamples;
        if (drawing.frame.isLinear()) {
            TileOutput.writeLinear(tile, drawing.frame, left, top, average);
        } else {
            float[] properties = drawing.input.rayTracingProperties();
            ToneStage.map(tile, properties, average * properties[Layout.EXPOSURE_SCALE]);
            ToneStage.pack(tile);
            TileOutput.write(tile, drawing.frame, left, top);
        }
    }
}
