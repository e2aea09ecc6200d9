package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.Lanes;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.SkyRadiance;

/** The sky that a tile's rays see, by the fastest method that applies. */
public final class TileSky {
    /** With fewer packets, arc tangents are used, because a chart has a cost per block. The limit is an estimate. */
    private static final int LEAST_CHARTED = Tile.SIZE / Lanes.COUNT / 4;

    /**
     * Number of small tiles during which the code for large frames also runs on dummy data, so that C2 compiles it
     * early: small frames warm up an engine.
     */
    private static final int REHEARSALS = 20_000;

    private final SkyChart chart = new SkyChart();
    private final SkyWindow window = new SkyWindow();
    private int rehearsals;

    /** Prepares a frame. */
    public void start(Drawing drawing) {
        chart.start(drawing);
    }

    /** Whether the chart covers a tile's view rays and their mirror images in a level plane. */
    boolean isCharted(Drawing drawing, Tile tile) {
        return drawing.shortcuts.take(Shortcut.SKY_CHART) && chart.covers(tile, drawing);
    }

    /** Whether the chart covers the tile and enough packets see the sky for it to be faster. */
    public boolean pays(Tile tile, Drawing drawing) {
        return tile.skies.count >= LEAST_CHARTED && isCharted(drawing, tile);
    }

    /** Adds the sky that a charted tile's view rays see, or their mirror images. */
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

    /** Loads the texels that a charted tile sees into the window; returns whether they fit. */
    private boolean isInWindow(Drawing drawing, Tile tile, boolean mirrored) {
        return SkyWindow.FIT
                && drawing.shortcuts.take(Shortcut.SKY_WINDOW)
                && chart.open(window, tile, drawing, mirrored);
    }

    /** Adds the sky at the columns and rows of the tile's packets. */
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

    /** Runs the code on whatever chart and window hold; the result is discarded. */
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
