package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.kernel.Layout;
import java.util.Arrays;

/** Tiles whose pixels are all handled alike, so that their constant columns are written only once. */
public final class WholeTiles {
    private final TileSky sky;

    /** Tile of sky. */
    private final Tile clear = new Tile();

    /** Tile of {@link OpenGround}. */
    private final Tile open = new Tile();

    /** Shares the sky of the same thread. */
    public WholeTiles(TileSky sky) {
        this.sky = sky;
        for (Tile skyward : new Tile[] {clear, open}) {
            skyward.live.addAll();
            skyward.skies.addAll();
            Arrays.fill(skyward.values, Tile.HIT, Tile.HIT + Tile.SIZE, Layout.NOTHING);
        }
        Arrays.fill(clear.values, Tile.THROUGHPUT, Tile.THROUGHPUT + Tile.SIZE, 1f);
    }

    /** Runs code that small frames do not reach, so that C2 compiles it early. */
    public void rehearse(Drawing drawing) {
        sky.rehearse(clear, drawing);
    }

    /** Renders a tile whose view rays hit nothing; returns a tile with the result. */
    public Tile addSky(Tile tile, Drawing drawing) {
        clear.moveTo(tile);
        CameraLanes.blacken(clear);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            clear.sample = sample;
            sky.addCharted(clear, drawing, false);
        }
        return clear;
    }

    /** Renders a tile of lit ground that reflects only the sky, or nothing; returns a tile with the result. */
    public Tile addOpenGround(Tile tile, Drawing drawing) {
        open.moveTo(tile);
        CameraLanes.blacken(open);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            open.sample = sample;
            OpenGround.add(drawing, open);
            if (OpenGround.mirrors(drawing)) {
                sky.addCharted(open, drawing, true);
            }
        }
        return open;
    }
}
