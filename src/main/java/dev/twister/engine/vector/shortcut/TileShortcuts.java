package dev.twister.engine.vector.shortcut;

import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.frame.Shortcut;
import dev.twister.engine.vector.lanes.ShadowColumns;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.kernel.Layout;

/** Decides which shortcuts apply to a tile and to the rays of a bounce. */
public final class TileShortcuts {
    /** Ways to render a tile. */
    public enum Way {
        /** Only sky. */
        SKY,
        /** Fully lit ground that reflects only the sky, or nothing. */
        OPEN_GROUND,
        /** Fully lit ground that reflects bodies. */
        LIT_GROUND,
        /** Only ground. */
        GROUND,
        /** Anything else, ray by ray. */
        ANY
    }

    private final TileSky sky;

    /** Possible occluders between a tile's ground and the light. */
    private final ShadowColumns shadows;

    /** The region of the live rays. */
    private final BoundingCone rays = new BoundingCone();

    /** For ground tiles: the region between the visible part of the plane and the light. */
    private final BoundingCone ground = new BoundingCone();

    /** For ground tiles: the region of the mirrored view rays. */
    private final BoundingCone mirrored = new BoundingCone();

    /**
     * Shares the sky of the same thread.
     *
     * @param shadows shadow columns of the same thread
     */
    public TileShortcuts(TileSky sky, ShadowColumns shadows) {
        this.sky = sky;
        this.shadows = shadows;
    }

    /** The region between the ground and the light, valid for ground tiles. */
    public BoundingCone ground() {
        return ground;
    }

    /** Chooses how to render a tile, and lists the bodies that its view rays may hit. */
    public Way choose(Tile tile, Drawing drawing) {
        Way way = Way.ANY;
        if (!drawing.crowded && !drawing.lens) {
            cullViewRays(drawing, tile);
            if (!drawing.severalLights
                    && drawing.shortcuts.take(Shortcut.CULLING)
                    && tile.candidates.count == 0
                    && !tile.nearMeshes) {
                way = chooseWithoutBodies(drawing, tile);
            }
        }
        return way;
    }

    /** Lists the bodies that the tile's view rays may hit, unless they start at a lens. */
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

    /** Whether no occluder is between a tile's ground and the light. */
    private boolean isLit(Drawing drawing) {
        boolean lit = drawing.shortcuts.take(Shortcut.OPEN_GROUND)
                && OpenGround.suits(drawing)
                && ground.isWithin(OpenGround.REACH);
        if (lit) {
            ground.listTowardsLight(shadows, drawing, drawing.lights[0]);
            lit = shadows.tileCandidates.count == 0 && !ground.touchesMesh(drawing);
        }
        return lit;
    }

    /** Whether a mesh may be between a tile's ground and the light. */
    private boolean isNearMeshes(Drawing drawing) {
        boolean near = drawing.bodies.meshes.count > 0;
        if (near) {
            ground.listTowardsLight(shadows, drawing, drawing.lights[0]);
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
     * Lists the bodies that the live rays may hit; returns whether all rays rise above the ground.
     *
     * @param bounce number of surfaces that the rays have left
     * @param offPlane whether the rays are the mirror images of all of the tile's view rays
     */
    public boolean cull(Tile tile, Drawing drawing, int bounce, boolean offPlane) {
        if (offPlane) {
            rays.mirror(drawing.planeHeight);
            cull(tile, drawing);
        } else if (bounce > 0 || drawing.lens) {
            rays.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT);
            rays.holdRays(tile, tile.live);
            cull(tile, drawing);
        }
        return drawing.shortcuts.take(Shortcut.CULLING) && (offPlane || rays.rises(drawing.planeHeight));
    }
}
