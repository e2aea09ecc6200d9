package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.SkyRadiance;

/** The sky that a tile's rays look at, by the fastest way that applies. */
public final class TileSky {
    /**
     * Fewer packets go by arc tangents, as a chart has its nodes to find first; from how many on it pays was not
     * measured.
     */
    private static final int LEAST_CHARTED = Tile.SIZE / Lanes.COUNT / 4;

    /**
     * During the first tiles, this many, of small pictures, the code of large ones also runs on dummy data, so that C2
     * compiles it early: engines are warmed up by small pictures.
     */
    private static final int REHEARSALS = 20_000;

    private final SkyChart chart = new SkyChart();
    private final SkyWindow window = new SkyWindow();
    private int rehearsals;

    /** Prepares for a frame. */
    public void start(Drawing drawing) {
        chart.start(drawing);
    }

    /**
     * Whether the chart has the directions of all of a tile's view rays, and of their mirror images in a level plane.
     */
    boolean isCharted(Drawing drawing, Tile tile) {
        return drawing.shortcuts.take(Shortcut.SKY_CHART) && chart.covers(tile, drawing);
    }

    /** The same, if enough of the packets meet the sky for it to pay. */
    public boolean pays(Tile tile, Drawing drawing) {
        return tile.skies.count >= LEAST_CHARTED && isCharted(drawing, tile);
    }

    /** Adds the sky that a charted tile's view rays look at, or their mirror images. */
    public void addCharted(Tile tile, Drawing drawing, boolean mirrored) {
        place(drawing, tile, mirrored);
        if (isInWindow(drawing, tile, mirrored)) {
            window.add(tile);
        } else {
            add(tile, drawing);
        }
    }

    private void place(Drawing drawing, Tile tile, boolean mirrored) {
        chart.spread(tile, drawing);
        chart.place(tile, drawing, mirrored);
    }

    /** Whether the window holds all texels that a charted tile looks at; fetches them. */
    private boolean isInWindow(Drawing drawing, Tile tile, boolean mirrored) {
        return SkyWindow.FIT
                && drawing.shortcuts.take(Shortcut.SKY_WINDOW)
                && chart.open(window, tile, drawing, mirrored);
    }

    /** Adds the sky at the columns and rows that the tile's packets look at. */
    public static void add(Tile tile, Drawing drawing) {
        if (!drawing.shortcuts.take(Shortcut.SKY_PATCHES)) {
            tile.scatteredSkies.copy(tile.skies);
        } else if (SkyRows.FIT && drawing.sky.halved) {
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
            SkyRadiance.lookUp(drawing.sky, tile);
        }
    }

    /** With whatever chart and window hold: only lanes come of it. */
    void rehearse(Tile clear, Drawing drawing) {
        if (chart.isCoarse() && rehearsals < REHEARSALS) {
            rehearsals++;
            clear.sample = 0;
            place(drawing, clear, false);
            if (SkyWindow.FIT) {
                window.add(clear);
            }
        }
    }
}
