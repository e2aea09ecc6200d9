package dev.twister.engine.vector;

import dev.twister.engine.vector.crowd.Walks;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.shadow.ShadowBench;
import dev.twister.engine.vector.shortcut.Choices;
import dev.twister.engine.vector.shortcut.TileSky;
import dev.twister.engine.vector.shortcut.WholeTiles;

/** One thread's tile and tools. */
final class Workbench {
    final Tile tile = new Tile();
    final Handover handover = new Handover();
    final Walks walks = new Walks();
    final ShadowBench shadows = new ShadowBench(walks);
    final TileSky sky = new TileSky();
    final WholeTiles wholeTiles = new WholeTiles(sky);
    final Choices choices = new Choices(sky, shadows.columns);

    /** Prepares for a frame. */
    void start(Drawing drawing) {
        tile.candidates.reserve(drawing.input.bodyCount());
        shadows.start(drawing);
        sky.start(drawing);
    }
}
