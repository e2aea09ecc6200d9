package dev.twister.engine.vector;

import dev.twister.kernel.Layout;

/**
 * The steps of drawing a tile. The compiler is told to inline none of them ({@link StageInlining}): each so keeps an inlining
 * budget of its own, without which vectors become objects. Calls through an interface with many implementations would do as
 * well, but take up to a twentieth of a frame.
 *
 * <p>A stage is not run for an empty list of packets, as the compiler makes objects in a loop that hardly any call comes to.
 */
final class Stages {
    private Stages() {}

    static void startRays(Tile tile, Drawing drawing) {
        ViewRays.start(tile, drawing);
    }

    static void placeRays(Tile tile, Drawing drawing) {
        ViewRays.place(tile, drawing.input.view().camera());
    }

    static void boundRays(Tile tile, Drawing drawing) {
        ViewRays.bound(tile, drawing);
    }

    static void cullRays(Tile tile, Drawing drawing) {
        tile.rays.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
    }

    static void cullMirrored(Tile tile, Drawing drawing) {
        tile.mirrored.cull(drawing.bodies, Layout.LIGHT, tile.candidates);
    }

    static void holdOrigins(Tile tile) {
        tile.rays.startAround(tile, tile.live, Tile.ORIGIN_X, Tile.THROUGHPUT);
    }

    static void holdDirections(Tile tile) {
        tile.rays.holdRays(tile, tile.live);
    }

    static void sortSkies(Tile tile) {
        HitSorting.sortSkies(tile);
    }

    static void findNearestOfFew(Tile tile, Drawing drawing) {
        NearestSphere.find(tile, drawing.bodies, tile.candidates);
    }

    static void findNearestOfMany(Tile tile, Drawing drawing) {
        PacketHits.find(tile, drawing);
    }

    static void findGround(Tile tile, Drawing drawing) {
        GroundHit.find(tile, drawing.planeHeight, drawing.planeHalfSide);
    }

    static void sortHits(Tile tile) {
        HitSorting.sort(tile);
    }

    static void addLight(Tile tile, Drawing drawing) {
        LightHit.add(tile, drawing.bodies);
    }

    static void findSkyRatios(Tile tile) {
        SkyDirection.findRatios(tile);
    }

    static void findAnglesAround(Tile tile) {
        SkyDirection.findArcTangents(tile, Tile.SKY_TO_RIGHT);
    }

    static void findElevations(Tile tile) {
        SkyDirection.findArcTangents(tile, Tile.SKY_TO_BOTTOM);
    }

    static void findSkyColumns(Tile tile, Drawing drawing) {
        SkyDirection.findColumns(tile, drawing.sky);
    }

    static void findSkyRows(Tile tile, Drawing drawing) {
        SkyDirection.findRows(tile, drawing.sky);
    }

    static void sortSkyInPatches(Tile tile) {
        SkyPatches.sort(tile);
    }

    static void addSkyInPatches(Tile tile, Drawing drawing) {
        SkyPatches.add(tile, drawing.sky);
    }

    static void sortSkyInRows(Tile tile) {
        SkyRows.sort(tile);
    }

    static void addSkyInRows(Tile tile, Drawing drawing) {
        SkyRows.add(tile, drawing.sky);
    }

    static void listScattered(Tile tile) {
        SkyRadiance.listPixels(tile);
    }

    static void findScatteredTexels(Tile tile, Drawing drawing) {
        SkyRadiance.findTexels(tile, drawing.sky);
    }

    static void fetchScattered(Tile tile, Drawing drawing) {
        SkyRadiance.fetch(tile, drawing.sky);
    }

    static void unpackScattered(Tile tile, Drawing drawing) {
        SkyRadiance.unpack(tile, drawing.sky);
    }

    static void addScattered(Tile tile, Drawing drawing) {
        SkyRadiance.add(tile, drawing.sky);
    }

    static void findGroundPoints(Tile tile, Drawing drawing) {
        GroundSurface.findPoints(tile, drawing);
    }

    static void colorGround(Tile tile, Drawing drawing) {
        GroundSurface.findColors(tile, drawing);
    }

    static void fetchSpheres(Tile tile, Drawing drawing) {
        SphereSurface.fetch(tile, drawing);
    }

    static void findSphereOffsets(Tile tile) {
        SphereSurface.findOffsets(tile);
    }

    static void findSpherePoints(Tile tile) {
        SphereSurface.findPoints(tile);
    }

    static void findLightDirections(Tile tile, Drawing drawing) {
        LightDirection.find(tile, drawing.bodies);
    }

    static void sortLightDirections(Tile tile, Drawing drawing) {
        LightDirection.sort(tile, drawing.ambient);
    }

    static void findShadows(Tile tile, Drawing drawing) {
        Shadows.find(tile, drawing);
    }

    static void findHighlightCosines(Tile tile) {
        Highlight.findCosines(tile);
    }

    static void sortHighlights(Tile tile) {
        Highlight.sort(tile);
    }

    static void raiseHighlights(Tile tile) {
        Highlight.raise(tile);
    }

    static void shade(Tile tile, Drawing drawing) {
        Bounce.shade(tile, drawing.bodies, drawing.ambient);
    }

    static void reflect(Tile tile) {
        Bounce.reflect(tile);
    }

    static void leave(Tile tile) {
        Bounce.leave(tile);
    }

    static void meetGroundAlone(Tile tile, Drawing drawing) {
        GroundAlone.meet(tile, drawing);
    }

    static void findLightOfGroundAlone(Tile tile, Drawing drawing) {
        GroundAlone.findLight(tile, drawing);
    }

    static void findShadowsOnGround(Tile tile, Drawing drawing) {
        Shadows.findOnGround(tile, drawing);
    }

    static void findHighlightOfGroundAlone(Tile tile, Drawing drawing) {
        GroundAlone.findHighlight(tile, drawing);
    }

    static void leaveGroundAlone(Tile tile) {
        GroundAlone.leave(tile);
    }

    static void listBetweenGroundAndLight(Tile tile, Drawing drawing) {
        Shadows.listBetween(tile.ground, tile, drawing);
    }

    static void meetOpenGround(Tile tile, Drawing drawing) {
        OpenGround.meet(tile, drawing);
    }

    static void findCosinesOfOpenGround(Tile tile, Drawing drawing) {
        OpenGround.findCosines(tile, drawing);
    }

    static void rootCosinesOfOpenGround(Tile tile) {
        OpenGround.root(tile);
    }

    static void raiseHighlightOfOpenGround(Tile tile, Drawing drawing) {
        OpenGround.raise(tile, drawing);
    }

    static void shadeOpenGround(Tile tile, Drawing drawing) {
        OpenGround.shade(tile, drawing);
    }

    static void leaveOpenGround(Tile tile, Drawing drawing) {
        OpenGround.leave(tile, drawing);
    }

    static void mapTones(Tile tile, Drawing drawing) {
        ToneStage.map(tile, drawing.input.view().properties(), drawing.pixelSamples);
    }

    static void packPixels(Tile tile, Drawing drawing) {
        ToneStage.pack(tile, drawing.input.view().properties(), drawing.pixelSamples);
    }

    static void writePixels(Tile tile, Drawing drawing) {
        TileOutput.write(tile, drawing.frame);
    }

    static void writeRadiance(Tile tile, Drawing drawing) {
        TileOutput.writeLinear(tile, drawing.frame, 1f / drawing.pixelSamples);
    }

    static void spreadChart(SkyChart chart, Tile tile, Drawing drawing) {
        chart.spread(tile, drawing);
    }

    static void placeChart(SkyChart chart, Tile tile, Drawing drawing, boolean mirrored) {
        chart.place(tile, drawing, mirrored);
    }

    static void addSkyInWindow(SkyWindow window, Tile tile) {
        window.add(tile);
    }

    static void raiseToOnePower(Tile tile) {
        Highlight.raiseAll(tile);
    }

    static void raiseToWholePowers(Tile tile) {
        Highlight.raiseEach(tile, tile.wholePowers, Tile.SPECULAR_WEIGHT);
    }

    static void findFractions(Tile tile) {
        Highlight.findFractions(tile);
    }

    static void raiseToFractionPowers(Tile tile) {
        Highlight.raiseEach(tile, tile.fractionPowers, Tile.FRACTION_POWER);
    }

    static void weighFractions(Tile tile) {
        Highlight.weigh(tile.values, tile.fractionPowers);
    }

    static void pickSpheres(Tile tile, Drawing drawing) {
        SphereSurface.pick(tile, drawing.bodies);
    }

    static void copySpheres(Tile tile, Drawing drawing) {
        SphereSurface.copy(tile, drawing.bodies);
    }

    static void copySpheresOfMany(Tile tile, Drawing drawing) {
        SphereSurface.copyOfMany(tile, drawing.bodies);
    }

    static void findShadowAxes(Tile tile, Drawing drawing, int at) {
        ShadowFrame.findAxes(tile, at, drawing, tile.shadow);
    }

    static void placeCandidates(Tile tile, Drawing drawing, int at) {
        ShadowFrame.placeAll(tile, at, drawing.bodies, tile.shadow);
    }

    static void limitCandidates(Tile tile, Drawing drawing, int at) {
        ShadowFrame.limitAll(tile, at, drawing.bodies, tile.shadow);
    }

    static void judgeCandidates(Tile tile, Drawing drawing, int at) {
        ShadowFrame.judgeAll(tile, at, drawing.bodies, tile.shadow);
    }

    static void prepareConics(Tile tile) {
        ShadowConics.prepare(tile.shadow);
    }

    static void chooseRange(Tile tile, Drawing drawing) {
        ShadowRange.choose(drawing, tile.shadow);
    }

    static void findRangePlaces(Tile tile, int at) {
        ShadowRange.findPlaces(tile.values, at, tile.shadow);
    }

    static void findRanges(Tile tile, Drawing drawing) {
        ShadowRange.find(drawing, tile.shadow);
    }

    static void countBlocked(Tile tile, Drawing drawing, int at) {
        Shadows.count(tile, drawing, at);
    }

    static void finishShadows(Tile tile, Drawing drawing, int at) {
        Shadows.finish(tile, drawing, at);
    }

    static void countConic(ShadowScratch scratch, int candidate) {
        ShadowConics.countOne(scratch, candidate);
    }

    static void countConicOfFew(ShadowScratch scratch, int candidate) {
        ShadowConics.countFew(scratch, candidate);
    }

    static void lowerConics(ShadowScratch scratch, int from, int candidate) {
        ShadowConics.lower(scratch, from, candidate);
    }

    static void countLowestConics(ShadowScratch scratch, int samples) {
        ShadowConics.countLowest(scratch, samples);
    }

    static float spreadOfHull(Hull hull, Tile tile, PacketList packets, int column, int lanes) {
        return hull.spread(tile, packets, column, lanes);
    }
}
