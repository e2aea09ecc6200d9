package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.step.CameraLanes;
import dev.twister.kernel.Layout;
import java.util.Arrays;

/** Tiles that look alike in all pixels: what never changes in them is written once. */
public final class WholeTiles {
    private final TileSky sky;

    /** All sky. */
    private final Tile clear = new Tile();

    /** All {@link OpenGround}. */
    private final Tile open = new Tile();

    /** With the sky of the same thread. */
    public WholeTiles(TileSky sky) {
        this.sky = sky;
        for (Tile skyward : new Tile[] {clear, open}) {
            skyward.live.addAll();
            skyward.skies.addAll();
            Arrays.fill(skyward.values, Tile.HIT, Tile.HIT + Tile.SIZE, Layout.NOTHING);
        }
        Arrays.fill(clear.values, Tile.THROUGHPUT, Tile.THROUGHPUT + Tile.SIZE, 1f);
    }

    /** Gives the JVM something to compile, where pictures are too small for what larger ones come to. */
    public void rehearse(Drawing drawing) {
        sky.rehearse(clear, drawing);
    }

    /** The same tile of the frame, whose view rays meet nothing. */
    public Tile addSky(Tile tile, Drawing drawing) {
        clear.moveTo(tile);
        CameraLanes.blacken(clear);
        for (int sample = 0; sample < drawing.pixelSamples; sample++) {
            clear.sample = sample;
            sky.addCharted(clear, drawing, false);
        }
        return clear;
    }

    /** The same tile of the frame, whose view rays meet lit ground that mirrors the sky alone, or nothing. */
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
