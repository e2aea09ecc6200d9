package dev.twister.engine.vector;

import dev.twister.engine.vector.crowd.PacketHits;
import dev.twister.engine.vector.frame.Drawing;
import dev.twister.engine.vector.lanes.Tile;
import dev.twister.engine.vector.mesh.MeshHits;
import dev.twister.engine.vector.mesh.MeshShadows;
import dev.twister.engine.vector.mesh.MeshSurfaceLanes;
import dev.twister.engine.vector.shadow.Shadows;
import dev.twister.engine.vector.shortcut.TileSky;
import dev.twister.engine.vector.step.BranchLanes;
import dev.twister.engine.vector.step.FacetLanes;
import dev.twister.engine.vector.step.GroundHit;
import dev.twister.engine.vector.step.GroundSurface;
import dev.twister.engine.vector.step.Highlight;
import dev.twister.engine.vector.step.HitSorting;
import dev.twister.engine.vector.step.LightDirection;
import dev.twister.engine.vector.step.LightHit;
import dev.twister.engine.vector.step.MaterialLanes;
import dev.twister.engine.vector.step.MetalLanes;
import dev.twister.engine.vector.step.NearestSphere;
import dev.twister.engine.vector.step.RefractionLanes;
import dev.twister.engine.vector.step.ScatterLanes;
import dev.twister.engine.vector.step.SeveralLightLanes;
import dev.twister.engine.vector.step.SkyDirection;
import dev.twister.engine.vector.step.SphereSurface;
import dev.twister.engine.vector.step.TextureLanes;
import dev.twister.engine.vector.step.TransmittingSphere;
import dev.twister.engine.vector.step.TransmittingSurface;

/** Renders one bounce of a tile's rays: closest hits, surfaces, shadows, shading and secondary rays. */
final class BounceRenderer {
    private final TileMemory bench;

    BounceRenderer(TileMemory bench) {
        this.bench = bench;
    }

    /** Follows the live rays to their closest hits and shades these. */
    void follow(Drawing drawing, Tile rays, int bounce, boolean offPlane) {
        rays.last = bounce == drawing.bounceLimit;
        findHits(drawing, rays, bounce, offPlane);
        if (drawing.declined.isAnyBody()) {
            bench.handover.endAtHits(rays, drawing, bounce);
        }
        if (rays.lights.count > 0) {
            LightHit.add(rays, drawing);
        }
        if (rays.skies.count > 0) {
            addSky(drawing, rays, (bounce == 0 && !drawing.lens) || offPlane, offPlane);
        }
        if (rays.grounds.count > 0) {
            GroundSurface.find(drawing, rays);
        }
        if (rays.spheres.count > 0) {
            SphereSurface.find(drawing, rays);
        }
        rays.meshes.clear();
        if (rays.nearMeshes && rays.spheres.count > 0) {
            MeshSurfaceLanes.find(drawing, rays, bench.meshes);
        }
        if (rays.surfaces.count > 0) {
            shade(drawing, rays, bounce);
        } else {
            rays.live.clear();
        }
    }

    /** Finds the closest hits of the live rays and sorts the rays by the kind of body hit. */
    void findHits(Drawing drawing, Tile rays, int bounce, boolean offPlane) {
        boolean rise = offPlane;
        if (drawing.crowded) {
            rays.nearMeshes = drawing.bodies.meshes.count > 0;
            PacketHits.find(rays, drawing, bench.walks);
        } else {
            rise = bench.choices.cull(rays, drawing, bounce, offPlane);
            if (rise && rays.candidates.count == 0 && !rays.nearMeshes && !drawing.lightSpheres) {
                HitSorting.sortSkies(rays);
                return;
            }
            if (drawing.looks.transparent) {
                TransmittingSphere.tellApart(rays, drawing.looks);
            }
            NearestSphere.find(rays, drawing.bodies, rays.candidates);
            if (drawing.looks.transparent) {
                TransmittingSphere.find(rays, drawing.bodies);
            }
        }
        if (!rise) {
            GroundHit.find(rays, drawing);
        }
        if (drawing.lightSpheres) {
            PacketHits.findLights(rays, drawing, bench.walks);
        }
        if (rays.nearMeshes) {
            MeshHits.find(drawing, rays, bench.meshes);
        }
        if (drawing.spots) {
            bench.handover.passSpots(rays, drawing);
        }
        HitSorting.sort(rays, drawing);
    }

    private void addSky(Drawing drawing, Tile rays, boolean ofViewRays, boolean mirrored) {
        if (ofViewRays && bench.sky.pays(rays, drawing)) {
            bench.sky.addCharted(rays, drawing, mirrored);
        } else {
            SkyDirection.find(drawing.sky, rays);
            TileSky.add(rays, drawing);
        }
    }

    /** Adds the light that the surfaces reflect toward the eye, and starts the secondary rays. */
    private void shade(Drawing drawing, Tile rays, int bounce) {
        if (drawing.looks.isAny()) {
            findMaterials(drawing, rays);
        }
        if (drawing.severalLights) {
            sumLights(drawing, rays, bounce);
        } else {
            illuminate(drawing, rays, bounce);
            if (drawing.looks.metallic) {
                MetalLanes.addHighlights(rays, drawing);
            }
        }
        ScatterLanes.shade(rays, drawing);
        if (drawing.looks.isAny()) {
            goOn(drawing, rays, bounce);
        } else {
            ScatterLanes.reflect(rays);
            ScatterLanes.leave(rays);
        }
        if (rays.meshes.count > 0) {
            MeshSurfaceLanes.leave(rays);
        }
    }

    private void sumLights(Drawing drawing, Tile rays, int bounce) {
        SeveralLightLanes.start(rays);
        for (int light = 0; light < drawing.lightCount; light++) {
            rays.light = light;
            illuminate(drawing, rays, bounce);
            SeveralLightLanes.add(rays, drawing);
        }
        rays.light = 0;
        SeveralLightLanes.finish(rays, drawing.looks.metallic);
    }

    /** Writes direction, visible part and highlight of the light that shades. */
    private void illuminate(Drawing drawing, Tile rays, int bounce) {
        LightDirection.find(drawing, rays);
        if (rays.meshes.count > 0) {
            MeshSurfaceLanes.darken(rays, drawing.bodies.meshes.firstBody);
        }
        if (drawing.looks.transparent) {
            TransmittingSurface.leaveInTheLight(rays);
        }
        if (drawing.mayDeclineShadows(drawing.lights[rays.light])) {
            bench.handover.findDeclinedShadows(rays, drawing, bounce);
        }
        findShadows(drawing, rays, bounce);
        Highlight.find(rays);
    }

    private void findShadows(Drawing drawing, Tile rays, int bounce) {
        boolean meshes = drawing.bodies.meshes.count > 0 && rays.shadows.count > 0;
        if (meshes) {
            MeshShadows.find(drawing, rays, bench.meshes);
        }
        Shadows.find(rays, drawing, bench.shadows);
        if (meshes && rays.meshShadows.count > 0) {
            bench.handover.mendShadows(rays, drawing, bounce);
        }
    }

    private static void findMaterials(Drawing drawing, Tile rays) {
        MaterialLanes.find(drawing, rays);
        if (drawing.looks.textured) {
            TextureLanes.multiply(drawing, rays);
        }
        if (drawing.looks.isBranching()) {
            MetalLanes.find(rays);
            TransmittingSurface.face(rays, drawing.bodies.meshes.firstBody);
        }
    }

    private boolean branches(Tile rays) {
        return rays == bench.branches || rays.transparent.count + rays.metals.count > 0;
    }

    /** Starts the secondary rays for materials with roughness, transmission, metal or texture. */
    private void goOn(Drawing drawing, Tile rays, int bounce) {
        if (drawing.looks.isBranching() && branches(rays)) {
            rays.live.clear();
            if (!rays.last) {
                FacetLanes.find(drawing, rays, rays.surfaces, bounce);
                RefractionLanes.find(drawing, rays);
                FacetLanes.reflect(rays, rays.surfaces);
                BranchLanes.split(rays, bench.waiting, bounce);
            }
        } else {
            if (drawing.looks.rough && rays.rough.count > 0 && rays.live.count > 0) {
                FacetLanes.find(drawing, rays, rays.live, bounce);
                FacetLanes.reflect(rays, rays.live);
            } else {
                ScatterLanes.reflect(rays);
            }
            ScatterLanes.leave(rays);
        }
    }
}
