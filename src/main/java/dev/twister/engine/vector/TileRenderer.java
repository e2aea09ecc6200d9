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

    // Stages in several lists are one object each: the JVM compiles each object's code anew.
    private static final Stage START_RAYS = (tile, drawing) -> ViewRays.start(tile, drawing);
    private static final Stage CULL_RAYS =
            (tile, drawing) -> tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
    private static final Stage FIND_SKY_RATIOS = (tile, drawing) -> SkyDirection.findRatios(tile);
    private static final Stage FIND_SKY_TO_RIGHT =
            (tile, drawing) -> SkyDirection.findArcTangents(tile, Tile.SKY_TO_RIGHT);
    private static final Stage FIND_SKY_TO_BOTTOM =
            (tile, drawing) -> SkyDirection.findArcTangents(tile, Tile.SKY_TO_BOTTOM);
    private static final Stage FIND_SKY_COLUMNS = (tile, drawing) -> SkyDirection.findColumns(tile, drawing.sky);
    private static final Stage FIND_SKY_ROWS = (tile, drawing) -> SkyDirection.findRows(tile, drawing.sky);
    private static final Stage COLOR_GROUND = (tile, drawing) -> GroundSurface.findColors(tile, drawing);
    private static final Stage RAISE_HIGHLIGHTS = (tile, drawing) -> Highlight.raise(tile, drawing);
    private static final Stage SHADE = (tile, drawing) -> Bounce.shade(tile, drawing.bodies, drawing.ambient);

    /** From the view rays of a chart's nodes to where they look. */
    static final Stage[] NODES = {
        START_RAYS, FIND_SKY_RATIOS, FIND_SKY_TO_RIGHT, FIND_SKY_TO_BOTTOM, FIND_SKY_COLUMNS, FIND_SKY_ROWS,
    };

    private static final Stage[] START = {
        START_RAYS, (tile, drawing) -> ViewRays.place(tile, drawing.input.camera()),
    };

    private static final Stage[] HOLD_VIEW = {
        (tile, drawing) -> ViewRays.bound(tile, drawing), CULL_RAYS,
    };

    private static final Stage[] CULL = {
        CULL_RAYS,
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

    private static final Stage[] GROUND_HIT = {
        (tile, drawing) -> GroundHit.find(tile, drawing.planeHeight, drawing.planeHalfSide),
    };

    private static final Stage[] SORT_HITS = {
        (tile, drawing) -> HitSorting.sort(tile),
    };

    private static final Stage[] LIGHT = {
        (tile, drawing) -> LightHit.add(tile, drawing.bodies),
    };

    private static final Stage[] SKY = {
        FIND_SKY_RATIOS, FIND_SKY_TO_RIGHT, FIND_SKY_TO_BOTTOM, FIND_SKY_COLUMNS, FIND_SKY_ROWS,
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
        (tile, drawing) -> GroundSurface.findPoints(tile, drawing), COLOR_GROUND,
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
        RAISE_HIGHLIGHTS,
        SHADE,
        (tile, drawing) -> Bounce.reflect(tile),
        (tile, drawing) -> Bounce.leave(tile),
    };

    private static final Stage[] GROUND_ALONE = {
        START_RAYS,
        (tile, drawing) -> GroundAlone.meet(tile, drawing),
        COLOR_GROUND,
        (tile, drawing) -> GroundAlone.findLight(tile, drawing),
        (tile, drawing) -> Shadows.findOnGround(tile, drawing),
        (tile, drawing) -> GroundAlone.findHighlight(tile, drawing),
        RAISE_HIGHLIGHTS,
        SHADE,
        (tile, drawing) -> GroundAlone.leave(tile),
    };

    private static final Stage[] SHADE_OPENLY = {
        (tile, drawing) -> Shadows.listBetween(tile.ground, tile, drawing),
    };

    private static final Stage[] MIRROR_VIEW = {
        (tile, drawing) -> tile.mirrored.cull(drawing.bodies, Layout.LIGHT, tile.candidates),
    };

    private static final Stage[] OPEN_GROUND = {
        (tile, drawing) -> OpenGround.meet(tile, drawing), (tile, drawing) -> OpenGround.findCosines(tile, drawing),
    };

    private static final Stage[] ODD_POWER = {
        (tile, drawing) -> OpenGround.root(tile),
    };

    private static final Stage[] MIRROR_LIT_GROUND = {
        START_RAYS, (tile, drawing) -> OpenGround.leave(tile, drawing),
    };

    private static final Stage[] SHADE_OPEN_GROUND = {
        (tile, drawing) -> OpenGround.raise(tile, drawing), (tile, drawing) -> OpenGround.shade(tile, drawing),
    };

    private static final Stage[] HOLD_ANEW = {
        (tile, drawing) -> tile.rays.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT),
        (tile, drawing) -> tile.rays.holdRays(tile, tile.live),
        CULL_RAYS,
    };

    private static final Stage[] FINISH_PIXELS = {
        (tile, drawing) -> ToneStage.map(tile, drawing.input.rayTracingProperties(), drawing.pixelSamples),
        (tile, drawing) -> ToneStage.pack(tile, drawing.input.rayTracingProperties(), drawing.pixelSamples),
        (tile, drawing) -> TileOutput.write(tile, drawing.frame),
    };

    private static final Stage[] FINISH_RADIANCE = {
        (tile, drawing) -> TileOutput.writeLinear(tile, drawing.frame, 1f / drawing.pixelSamples),
    };

    private final Tile tile = new Tile();

    /** Tiles that look past everything at the sky; what never changes in them is written once. */
    private final Tile clear = new Tile();

    /** Tiles of {@link OpenGround}, likewise. */
    private final Tile open = new Tile();

    private final SkyChart chart = new SkyChart();
    private final SkyWindow window = new SkyWindow();

    /** Whether the chart is asked for the view rays' mirror images. */
    private boolean mirrored;

    private final Stage[] chartedSky = {
        (tile, drawing) -> chart.spread(tile, drawing), (tile, drawing) -> chart.place(tile, drawing, mirrored),
    };

    private final Stage[] skyInWindow = {(tile, drawing) -> window.add(tile)};

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
        if (!drawing.crowded) {
            Stage.runAll(HOLD_VIEW, tile, drawing);
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
        Stage.runAll(chartedSky, clear, drawing);
        if (SkyWindow.FIT) {
            Stage.runAll(skyInWindow, clear, drawing);
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
            Stage.runAll(SHADE_OPENLY, tile, drawing);
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
        Stage.runAll(MIRROR_VIEW, tile, drawing);
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
        Stage.runAll(OPEN_GROUND, here, drawing);
        Stage.runFor(OpenGround.power(drawing) % 2, ODD_POWER, here, drawing);
        Stage.runAll(SHADE_OPEN_GROUND, here, drawing);
    }

    /** Draws a tile of lit ground that mirrors bodies. */
    private void drawLitGround(Drawing drawing) {
        listInside(drawing);
        ViewRays.blacken(tile);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            startSample(drawing, sample);
            shadeOpenGround(tile, drawing);
            Stage.runAll(MIRROR_LIT_GROUND, tile, drawing);
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
                Stage.runAll(HOLD_VIEW, tile, drawing);
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
                Stage.runAll(GROUND_ALONE, tile, drawing);
                follow(drawing, 1);
            } else {
                Stage.runAll(START, tile, drawing);
                follow(drawing, 0);
            }
        }
        finish(tile, drawing);
    }

    private static void finish(Tile tile, Drawing drawing) {
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

    /** Follows the live rays, which have met and left so many surfaces, to their ends. */
    private void follow(Drawing drawing, int firstBounce) {
        for (int bounce = firstBounce; bounce <= drawing.bounceLimit && tile.live.count > 0; bounce++) {
            tile.last = bounce == drawing.bounceLimit;
            boolean offPlane = bounce == 1 && tile.spheres.count == 0;
            if (drawing.crowded) {
                Stage.runAll(NEAREST_OF_MANY, tile, drawing);
                if (!offPlane) {
                    Stage.runAll(GROUND_HIT, tile, drawing);
                }
                Stage.runAll(SORT_HITS, tile, drawing);
            } else {
                meetFew(drawing, bounce, offPlane);
            }
            Stage.runFor(tile.lights.count, LIGHT, tile, drawing);
            if (tile.skies.count > 0) {
                if ((bounce == 0 || offPlane) && tile.skies.count >= LEAST_CHARTED && chart.covers(tile, drawing)) {
                    addChartedSky(tile, drawing, offPlane);
                } else {
                    Stage.runAll(SKY, tile, drawing);
                    addSky(tile, drawing);
                }
            }
            Stage.runFor(tile.grounds.count, GROUND, tile, drawing);
            Stage.runFor(tile.spheres.count, SPHERES, tile, drawing);
            Stage.runFor(tile.surfaces.count, SURFACE, tile, drawing);
            if (tile.surfaces.count == 0) {
                tile.live.clear();
            }
        }
    }

    /** Adds the sky that a covered tile's view rays look at, or their mirror images. */
    private void addChartedSky(Tile here, Drawing drawing, boolean inPlane) {
        mirrored = inPlane;
        Stage.runAll(chartedSky, here, drawing);
        if (SkyWindow.FIT && chart.open(window, here, drawing, mirrored)) {
            Stage.runAll(skyInWindow, here, drawing);
        } else {
            addSky(here, drawing);
        }
    }

    /** Adds the sky at the columns and rows that the tile's packets look at. */
    private static void addSky(Tile tile, Drawing drawing) {
        boolean inRows = SkyRows.FIT && drawing.sky.halved;
        Stage.runAll(inRows ? SORT_SKY_IN_ROWS : SORT_SKY, tile, drawing);
        Stage.runFor(tile.skyPatches.count, inRows ? SKY_ROWS : SKY_PATCHES, tile, drawing);
        Stage.runFor(tile.scatteredSkies.count, SCATTERED_SKY, tile, drawing);
    }

    /** Sorts the live rays by what they meet, where the hulls of all rays tell what cannot be met. */
    private void meetFew(Drawing drawing, int bounce, boolean offPlane) {
        if (offPlane) {
            tile.rays.mirror(drawing.planeHeight);
            Stage.runAll(CULL, tile, drawing);
        } else if (bounce > 0) {
            Stage.runAll(HOLD_ANEW, tile, drawing);
        }
        boolean upwards = offPlane || tile.rays.rises(drawing.planeHeight);
        if (upwards && tile.candidates.count == 0) {
            Stage.runAll(NOTHING_HIT, tile, drawing);
        } else {
            Stage.runAll(NEAREST_OF_FEW, tile, drawing);
            if (!upwards) {
                Stage.runAll(GROUND_HIT, tile, drawing);
            }
            Stage.runAll(SORT_HITS, tile, drawing);
        }
    }
}
