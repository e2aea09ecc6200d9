package dev.twister.engine.vector;

import dev.twister.engine.vector.crowd.TraversalMemory;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.lanes.WaitingRays;
import dev.twister.engine.vector.mesh.MeshMemory;
import dev.twister.engine.vector.shadow.ShadowMemory;
import dev.twister.engine.vector.shortcut.TileShortcuts;
import dev.twister.engine.vector.shortcut.TileSky;
import dev.twister.engine.vector.shortcut.WholeTiles;

/** One thread's tile and working memory. */
final class TileMemory {
    final Tile tile = new Tile();

    /** Tile of the branch rays that waited. */
    final Tile branches = new Tile();

    final WaitingRays waiting = new WaitingRays();
    final Handover handover = new Handover();
    final TraversalMemory walks = new TraversalMemory();
    final ShadowMemory shadows = new ShadowMemory(walks);
    final MeshMemory meshes = new MeshMemory(shadows);
    final TileSky sky = new TileSky();
    final WholeTiles wholeTiles = new WholeTiles(sky);
    final TileShortcuts choices = new TileShortcuts(sky, shadows.columns);

    /** Prepares for a frame. */
    void start(Drawing drawing) {
        tile.candidates.reserve(drawing.input.bodyCount());
        if (drawing.looks.isBranching()) {
            tile.transmitting.reserve(drawing.input.bodyCount());
            branches.candidates.reserve(drawing.input.bodyCount());
            branches.transmitting.reserve(drawing.input.bodyCount());
            waiting.reserve(drawing.bounceLimit);
        }
        shadows.start(drawing);
        sky.start(drawing);
    }
}
