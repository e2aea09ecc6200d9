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
        int bodies = drawing.input.bodyCount();
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
            Stages.boundRays(tile, drawing);
            Stages.cullRays(tile, drawing);
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
            Stages.addSkyInWindow(window, clear);
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
            Stages.listBetweenGroundAndLight(tile, drawing);
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
        Stages.cullMirrored(tile, drawing);
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
        Stages.meetOpenGround(here, drawing);
        Stages.findCosinesOfOpenGround(here, drawing);
        if (OpenGround.power(drawing) % 2 > 0) {
            Stages.rootCosinesOfOpenGround(here);
        }
        Stages.raiseHighlightOfOpenGround(here, drawing);
        Stages.shadeOpenGround(here, drawing);
    }

    /** Draws a tile of lit ground that mirrors bodies. */
    private void drawLitGround(Drawing drawing) {
        listInside(drawing);
        ViewRays.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            startSample(drawing, sample);
            shadeOpenGround(tile, drawing);
            Stages.startRays(tile, drawing);
            Stages.leaveOpenGround(tile, drawing);
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
                Stages.boundRays(tile, drawing);
                Stages.cullRays(tile, drawing);
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
                Stages.startRays(tile, drawing);
                Stages.placeRays(tile, drawing);
                follow(drawing, 0);
            }
        }
        finish(tile, drawing);
    }

    private static void finish(Tile tile, Drawing drawing) {
        if (drawing.frame.isLinear()) {
            Stages.writeRadiance(tile, drawing);
        } else {
            Stages.mapTones(tile, drawing);
            Stages.packPixels(tile, drawing);
            Stages.writePixels(tile, drawing);
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
                Stages.findNearestOfMany(tile, drawing);
                if (!offPlane) {
                    Stages.findGround(tile, drawing);
                }
                Stages.sortHits(tile);
            } else {
                meetFew(drawing, bounce, offPlane);
            }
            if (tile.lights.count > 0) {
                Stages.addLight(tile, drawing);
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
                Stages.findGroundPoints(tile, drawing);
                Stages.colorGround(tile, drawing);
            }
            if (tile.spheres.count > 0) {
                Stages.fetchSpheres(tile, drawing);
                Stages.findSphereOffsets(tile);
                Stages.findSpherePoints(tile);
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
        Stages.findLightDirections(tile, drawing);
        Stages.sortLightDirections(tile, drawing);
        Stages.findShadows(tile, drawing);
        Stages.findHighlightCosines(tile);
        Stages.sortHighlights(tile);
        Stages.raiseHighlights(tile);
        Stages.shade(tile, drawing);
        Stages.reflect(tile);
        Stages.leave(tile);
    }

    /** The same from the view rays on, which all meet the ground. */
    private void shadeGroundAlone(Drawing drawing) {
        Stages.startRays(tile, drawing);
        Stages.meetGroundAlone(tile, drawing);
        Stages.colorGround(tile, drawing);
        Stages.findLightOfGroundAlone(tile, drawing);
        Stages.findShadowsOnGround(tile, drawing);
        Stages.findHighlightOfGroundAlone(tile, drawing);
        Stages.raiseHighlights(tile);
        Stages.shade(tile, drawing);
        Stages.leaveGroundAlone(tile);
    }

    /** From the view rays of a chart's nodes to where in the panorama they look. */
    static void findNodes(Tile nodes, Drawing drawing) {
        Stages.startRays(nodes, drawing);
        findSky(nodes, drawing);
    }

    private static void findSky(Tile tile, Drawing drawing) {
        Stages.findSkyRatios(tile);
        Stages.findAnglesAround(tile);
        Stages.findElevations(tile);
        Stages.findSkyColumns(tile, drawing);
        Stages.findSkyRows(tile, drawing);
    }

    private void placeChartedSky(Tile here, Drawing drawing, boolean mirrored) {
        Stages.spreadChart(chart, here, drawing);
        Stages.placeChart(chart, here, drawing, mirrored);
    }

    /** Adds the sky that a covered tile's view rays look at, or their mirror images. */
    private void addChartedSky(Tile here, Drawing drawing, boolean mirrored) {
        placeChartedSky(here, drawing, mirrored);
        if (SkyWindow.FIT && chart.open(window, here, drawing, mirrored)) {
            Stages.addSkyInWindow(window, here);
        } else {
            addSky(here, drawing);
        }
    }

    /** Adds the sky at the columns and rows that the tile's packets look at. */
    private static void addSky(Tile tile, Drawing drawing) {
        if (SkyRows.FIT && drawing.sky.halved) {
            Stages.sortSkyInRows(tile);
            if (tile.skyPatches.count > 0) {
                Stages.addSkyInRows(tile, drawing);
            }
        } else {
            Stages.sortSkyInPatches(tile);
            if (tile.skyPatches.count > 0) {
                Stages.addSkyInPatches(tile, drawing);
            }
        }
        if (tile.scatteredSkies.count > 0) {
            Stages.listScattered(tile);
            Stages.findScatteredTexels(tile, drawing);
            Stages.fetchScattered(tile, drawing);
            Stages.unpackScattered(tile, drawing);
            Stages.addScattered(tile, drawing);
        }
    }

    /** Sorts the live rays by what they meet, where the hulls of all rays tell what cannot be met. */
    private void meetFew(Drawing drawing, int bounce, boolean offPlane) {
        if (offPlane) {
            tile.rays.mirror(drawing.planeHeight);
            Stages.cullRays(tile, drawing);
        } else if (bounce > 0) {
            Stages.holdOrigins(tile);
            Stages.holdDirections(tile);
            Stages.cullRays(tile, drawing);
        }
        boolean upwards = offPlane || tile.rays.rises(drawing.planeHeight);
        if (upwards && tile.candidates.count == 0) {
            Stages.sortSkies(tile);
        } else {
            Stages.findNearestOfFew(tile, drawing);
            if (!upwards) {
                Stages.findGround(tile, drawing);
            }
            Stages.sortHits(tile);
        }
    }
}
