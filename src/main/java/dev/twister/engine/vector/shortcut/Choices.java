package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;

/** Which shortcuts apply to a tile, and to the rays of a bounce. */
public final class Choices {
    /** How a tile is drawn. */
    public enum Way {
        /** Nothing but sky. */
        SKY,
        /** Ground in the light that mirrors the sky alone, or nothing. */
        OPEN_GROUND,
        /** Ground in the light that mirrors bodies. */
        LIT_GROUND,
        /** Nothing but ground. */
        GROUND,
        /** Ray by ray. */
        ANY
    }

    private final TileSky sky;

    /** What may come between a tile's ground and the light. */
    private final ShadowColumns shadows;

    /** The region that holds the live rays. */
    private final Hull rays = new Hull();

    /** The region between what the tile's view rays meet of the plane and the light, in a tile of ground. */
    private final Hull ground = new Hull();

    /** The region that holds the mirror images of the view rays of such a tile. */
    private final Hull mirrored = new Hull();

    /**
     * With the sky of the same thread.
     *
     * @param shadows those of the same thread
     */
    public Choices(TileSky sky, ShadowColumns shadows) {
        this.sky = sky;
        this.shadows = shadows;
    }

    /** Between the ground of a tile of ground and the light. */
    public Hull ground() {
        return ground;
    }

    /** How a tile is drawn; lists what its view rays may meet. */
    public Way choose(Tile tile, Drawing drawing) {
        Way way = Way.ANY;
        if (!drawing.crowded) {
            cullViewRays(drawing, tile);
            if (drawing.shortcuts.take(Shortcut.CULLING) && tile.candidates.count == 0 && !tile.nearMeshes) {
                way = chooseWithoutBodies(drawing, tile);
            }
        }
        return way;
    }

    /** Lists what the tile's view rays may meet. */
    public void cullViewRays(Drawing drawing, Tile tile) {
        rays.holdViewRays(tile, drawing);
        cull(tile, drawing);
    }

    private void cull(Tile tile, Drawing drawing) {
        rays.cull(tile, drawing);
        tile.nearMeshes = rays.touchesMesh(drawing);
    }

    private Way chooseWithoutBodies(Drawing drawing, Tile tile) {
        GroundAlone.View view =
                rays.rises(drawing.planeHeight) ? GroundAlone.View.NOTHING : GroundAlone.view(tile, drawing, ground);
        return switch (view) {
            case NOTHING ->
                drawing.shortcuts.take(Shortcut.SKY_TILES) && sky.isCharted(drawing, tile) ? Way.SKY : Way.ANY;
            case GROUND ->
                drawing.shortcuts.take(Shortcut.GROUND_TILES)
                                && drawing.looks.plainPlane
                                && !drawing.declined.isBody(Layout.PLANE)
                        ? chooseOnGround(drawing, tile)
                        : Way.ANY;
            case PART -> Way.ANY;
        };
    }

    private Way chooseOnGround(Drawing drawing, Tile tile) {
        if (!isLit(drawing)) {
            return drawing.declined.occluders().count > 0 || isNearMeshes(drawing) ? Way.ANY : Way.GROUND;
        }
        return OpenGround.mirrors(drawing) && !mirrorsSkyAlone(drawing, tile) ? Way.LIT_GROUND : Way.OPEN_GROUND;
    }

    /** Whether nothing is between a tile's ground and the light. */
    private boolean isLit(Drawing drawing) {
        boolean lit = drawing.shortcuts.take(Shortcut.OPEN_GROUND)
                && OpenGround.suits(drawing)
                && ground.isWithin(OpenGround.REACH);
        if (lit) {
            ground.listTowardsLight(shadows, drawing);
            lit = shadows.tileCandidates.count == 0 && !ground.touchesMesh(drawing);
        }
        return lit;
    }

    /** Whether a mesh may be between a tile's ground and the light. */
    private boolean isNearMeshes(Drawing drawing) {
        boolean near = drawing.bodies.meshes.count > 0;
        if (near) {
            ground.listTowardsLight(shadows, drawing);
            near = ground.touchesMesh(drawing);
        }
        return near;
    }

    private boolean mirrorsSkyAlone(Drawing drawing, Tile tile) {
        mirrored.hold(rays);
        mirrored.mirror(drawing.planeHeight);
        mirrored.cull(tile, drawing);
        return tile.candidates.count == 0 && !mirrored.touchesMesh(drawing) && sky.isCharted(drawing, tile);
    }

    /**
     * Lists what the live rays may meet; tells whether they all rise above the ground.
     *
     * @param bounce how many surfaces they have left
     * @param offPlane whether they are the mirror images of all of the tile's view rays
     */
    public boolean cull(Tile tile, Drawing drawing, int bounce, boolean offPlane) {
        if (offPlane) {
            rays.mirror(drawing.planeHeight);
            cull(tile, drawing);
        } else if (bounce > 0) {
            rays.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT);
            rays.holdRays(tile, tile.live);
            cull(tile, drawing);
        }
        return drawing.shortcuts.take(Shortcut.CULLING) && (offPlane || rays.rises(drawing.planeHeight));
    }
}
