package dev.twister.engine.vector;

import dev.twister.kernel.Layout;
import java.util.Arrays;

/** Draws tiles, stage by stage; one for each thread. */
final class TileRenderer {
    /** Fewer packets go by arc tangents, as a chart has its nodes to find first; from how many on it pays was not measured. */
    private static final int LEAST_CHARTED = Tile.SIZE / Lanes.COUNT / 4;

    /**
     * Beside so many tiles of pictures of few pixels, what only larger ones come to is done for nothing: an engine is warmed up by
     * small pictures, and what the JVM has not compiled by then makes the first large ones slow.
     */
    private static final int REHEARSALS = 20_000;

    private final Tile tile = new Tile();

    /** Tiles that look past everything at the sky; what never changes in them is written once. */
    private final Tile clear = new Tile();

    /** Tiles of {@link OpenGround}, likewise. */
    private final Tile open = new Tile();

    private final SkyChart chart = new SkyChart();
    private final SkyWindow window = new SkyWindow();

    private int rehearsals;

    TileRenderer() {
        for (Tile skyward : new Tile[] {clear, open}) {
            skyward.live.addAll();
            skyward.skies.addAll();
            Arrays.fill(skyward.values, Tile.HIT, Tile.HIT + Tile.SIZE, Layout.NOTHING);
        }
        Arrays.fill(clear.values, Tile.THROUGHPUT, Tile.THROUGHPUT + Tile.SIZE, 1f);
    }

    /** Prepares for a frame. */
    void start(Drawing drawing) {
        int bodies = drawing.input.bodies();
        tile.candidates.reserve(bodies);
        tile.shadow.reserveBodies(bodies);
        tile.near.reserveList(Shadows.MOST_NEAR + Lanes.COUNT);
        chart.start(drawing);
    }

    /** Draws the tile of that number, counted along the rows of tiles from the top left. */
    void draw(Drawing drawing, int number) {
        tile.left = number % drawing.tilesAcross() * Tile.SIDE;
        tile.top = number / drawing.tilesAcross() * Tile.SIDE;
        TileOutput.approachNext(tile, drawing.frame);
        if (!drawing.crowded) {
            ViewRays.bound(tile, drawing);
            tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
        }
        if (chart.isCoarse() && rehearsals < REHEARSALS) {
            rehearsals++;
            rehearse(drawing);
        }
        GroundAlone.View view = view(drawing);
        if (view == GroundAlone.View.NOTHING && chart.covers(tile, drawing)) {
            drawSky(drawing);
        } else if (view == GroundAlone.View.GROUND) {
            drawGround(drawing);
        } else {
            drawAll(drawing, false);
        }
    }

    /** With whatever chart and window hold: only lanes come of it. */
    private void rehearse(Drawing drawing) {
        clear.sample = 0;
        placeChartedSky(clear, drawing, false);
        if (SkyWindow.FIT) {
            window.add(clear);
        }
    }

    private GroundAlone.View view(Drawing drawing) {
        GroundAlone.View view = GroundAlone.View.PART;
        if (!drawing.crowded && tile.candidates.count == 0) {
            view = tile.rays.rises(drawing.planeHeight) ? GroundAlone.View.NOTHING : GroundAlone.view(tile, drawing);
        }
        return view;
    }

    /** Draws a tile whose view rays meet nothing. */
    private void drawSky(Drawing drawing) {
        clear.left = tile.left;
        clear.top = tile.top;
        ViewRays.blacken(clear);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            clear.sample = sample;
            addChartedSky(clear, drawing, false);
        }
        finish(clear, drawing);
    }

    /** Draws a tile whose view rays all meet the ground. */
    private void drawGround(Drawing drawing) {
        if (!isLit(drawing)) {
            drawAll(drawing, true);
        } else if (!mirrors(drawing) || mirrorsSkyAlone(drawing)) {
            drawOpenGround(drawing);
        } else {
            drawLitGround(drawing);
        }
    }

    /** Whether nothing is between a tile's ground and the light. */
    private boolean isLit(Drawing drawing) {
        boolean lit = OpenGround.suits(drawing);
        if (lit) {
            Shadows.listBetween(tile.ground, tile, drawing);
            lit = tile.shadow.tileCandidates.count == 0;
        }
        return lit;
    }

    private static boolean mirrors(Drawing drawing) {
        return drawing.bounceLimit > 0 && OpenGround.power(drawing) > 0;
    }

    private boolean mirrorsSkyAlone(Drawing drawing) {
        tile.mirrored.hold(tile.rays);
        tile.mirrored.mirror(drawing.planeHeight);
        tile.mirrored.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
        return tile.candidates.count == 0 && chart.covers(tile, drawing);
    }

    /** Draws a tile of lit ground that mirrors the sky alone, or nothing. */
    private void drawOpenGround(Drawing drawing) {
        open.left = tile.left;
        open.top = tile.top;
        ViewRays.blacken(open);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            open.sample = sample;
            shadeOpenGround(open, drawing);
            if (mirrors(drawing)) {
                addChartedSky(open, drawing, true);
            }
        }
        finish(open, drawing);
    }

    private static void shadeOpenGround(Tile here, Drawing drawing) {
        OpenGround.meet(here, drawing);
        OpenGround.findCosines(here, drawing);
        if (OpenGround.power(drawing) % 2 > 0) {
            OpenGround.root(here);
        }
        OpenGround.raise(here, drawing);
        OpenGround.shade(here, drawing);
    }

    /** Draws a tile of lit ground that mirrors bodies. */
    private void drawLitGround(Drawing drawing) {
        listInside(drawing);
        ViewRays.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            startSample(drawing, sample);
            shadeOpenGround(tile, drawing);
            ViewRays.start(tile, drawing);
            OpenGround.leave(tile, drawing);
            follow(drawing, 1);
        }
        finish(tile, drawing);
    }

    private void startSample(Drawing drawing, int sample) {
        tile.sample = sample;
        if (sample > 0) {
            // Following the last sample's rays has changed both.
            listInside(drawing);
            if (!drawing.crowded) {
                ViewRays.bound(tile, drawing);
                tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
            }
        }
    }

    private void drawAll(Drawing drawing, boolean groundAlone) {
        listInside(drawing);
        ViewRays.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            startSample(drawing, sample);
            if (groundAlone) {
                tile.last = drawing.bounceLimit == 0;
                shadeGroundAlone(drawing);
                follow(drawing, 1);
            } else {
                ViewRays.start(tile, drawing);
                ViewRays.place(tile, drawing.input.camera());
                follow(drawing, 0);
            }
        }
        finish(tile, drawing);
    }

    private static void finish(Tile tile, Drawing drawing) {
        if (drawing.frame.isLinear()) {
            TileOutput.writeLinear(tile, drawing.frame, 1f / drawing.pixelSamples);
        } else {
            ToneStage.map(tile, drawing.input.rayTracingProperties(), drawing.pixelSamples);
            ToneStage.pack(tile, drawing.input.rayTracingProperties(), drawing.pixelSamples);
            TileOutput.write(tile, drawing.frame);
        }
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

    /** Follows the live rays, which have met and left so many surfaces, to their ends. */
    private void follow(Drawing drawing, int firstBounce) {
        for (int bounce = firstBounce; bounce <= drawing.bounceLimit && tile.live.count > 0; bounce++) {
            tile.last = bounce == drawing.bounceLimit;
            boolean offPlane = bounce == 1 && tile.spheres.count == 0;
            if (drawing.crowded) {
                PacketHits.find(tile, drawing);
                if (!offPlane) {
                    GroundHit.find(tile, drawing.planeHeight, drawing.planeHalfSide);
                }
                HitSorting.sort(tile);
            } else {
                meetFew(drawing, bounce, offPlane);
            }
            if (tile.lights.count > 0) {
                LightHit.add(tile, drawing.bodies);
            }
            if (tile.skies.count > 0) {
                if ((bounce == 0 || offPlane) && tile.skies.count >= LEAST_CHARTED && chart.covers(tile, drawing)) {
                    addChartedSky(tile, drawing, offPlane);
                } else {
                    findSky(tile, drawing);
                    addSky(tile, drawing);
                }
            }
            if (tile.grounds.count > 0) {
                GroundSurface.findPoints(tile, drawing);
                GroundSurface.findColors(tile, drawing);
            }
            if (tile.spheres.count > 0) {
                SphereSurface.fetch(tile, drawing);
                SphereSurface.findOffsets(tile);
                SphereSurface.findPoints(tile);
            }
            if (tile.surfaces.count > 0) {
                shadeSurfaces(drawing);
            } else {
                tile.live.clear();
            }
        }
    }

    /** Adds what the surfaces send towards the eye, and starts the rays that go on. */
    private void shadeSurfaces(Drawing drawing) {
        LightDirection.find(tile, drawing.bodies);
        LightDirection.sort(tile, drawing.ambient);
        Shadows.find(tile, drawing);
        Highlight.findCosines(tile);
        Highlight.sort(tile);
        Highlight.raise(tile);
        Bounce.shade(tile, drawing.bodies, drawing.ambient);
        Bounce.reflect(tile);
        Bounce.leave(tile);
    }

    /** The same from the view rays on, which all meet the ground. */
    private void shadeGroundAlone(Drawing drawing) {
        ViewRays.start(tile, drawing);
        GroundAlone.meet(tile, drawing);
        GroundSurface.findColors(tile, drawing);
        GroundAlone.findLight(tile, drawing);
        Shadows.findOnGround(tile, drawing);
        GroundAlone.findHighlight(tile, drawing);
        Highlight.raise(tile);
        Bounce.shade(tile, drawing.bodies, drawing.ambient);
        GroundAlone.leave(tile);
    }

    /** From the view rays of a chart's nodes to where in the panorama they look. */
    static void findNodes(Tile nodes, Drawing drawing) {
        ViewRays.start(nodes, drawing);
        findSky(nodes, drawing);
    }

    private static void findSky(Tile tile, Drawing drawing) {
        SkyDirection.findRatios(tile);
        SkyDirection.findArcTangents(tile, Tile.SKY_TO_RIGHT);
        SkyDirection.findArcTangents(tile, Tile.SKY_TO_BOTTOM);
        SkyDirection.findColumns(tile, drawing.sky);
        SkyDirection.findRows(tile, drawing.sky);
    }

    private void placeChartedSky(Tile here, Drawing drawing, boolean mirrored) {
        chart.spread(here, drawing);
        chart.place(here, drawing, mirrored);
    }

    /** Adds the sky that a covered tile's view rays look at, or their mirror images. */
    private void addChartedSky(Tile here, Drawing drawing, boolean mirrored) {
        placeChartedSky(here, drawing, mirrored);
        if (SkyWindow.FIT && chart.open(window, here, drawing, mirrored)) {
            window.add(here);
        } else {
            addSky(here, drawing);
        }
    }

    /** Adds the sky at the columns and rows that the tile's packets look at. */
    private static void addSky(Tile tile, Drawing drawing) {
        if (SkyRows.FIT && drawing.sky.halved) {
            SkyRows.sort(tile);
            if (tile.skyPatches.count > 0) {
                SkyRows.add(tile, drawing.sky);
            }
        } else {
            SkyPatches.sort(tile);
            if (tile.skyPatches.count > 0) {
                SkyPatches.add(tile, drawing.sky);
            }
        }
        if (tile.scatteredSkies.count > 0) {
            SkyRadiance.listPixels(tile);
            SkyRadiance.findTexels(tile, drawing.sky);
            SkyRadiance.fetch(tile, drawing.sky);
            SkyRadiance.unpack(tile, drawing.sky);
            SkyRadiance.add(tile);
        }
    }

    /** Sorts the live rays by what they meet, where the hulls of all rays tell what cannot be met. */
    private void meetFew(Drawing drawing, int bounce, boolean offPlane) {
        if (offPlane) {
            tile.rays.mirror(drawing.planeHeight);
            tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
        } else if (bounce > 0) {
            tile.rays.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT);
            tile.rays.holdRays(tile, tile.live);
            tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
        }
        boolean upwards = offPlane || tile.rays.rises(drawing.planeHeight);
        if (upwards && tile.candidates.count == 0) {
            HitSorting.sortSkies(tile);
        } else {
            NearestSphere.find(tile, drawing.bodies, tile.candidates);
            if (!upwards) {
                GroundHit.find(tile, drawing.planeHeight, drawing.planeHalfSide);
            }
            HitSorting.sort(tile);
        }
    }
}
