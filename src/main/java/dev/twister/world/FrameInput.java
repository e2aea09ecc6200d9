package dev.twister.world;

import dev.twister.kernel.Guides;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.kernel.Views;
import dev.twister.scene.ToneMap;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * A snapshot of the world as the flat arrays that the kernel reads.
 *
 * <p>The arrays of a snapshot are immutable: a changing world creates new arrays and reuses those that are still valid.
 * An engine can therefore recognize by identity that its copy of an array, such as one on a device, is still valid.
 *
 * @param images the array {@code images} of {@link Layout}: texels of the sky, then of the textures
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts
public record FrameInput(View view, Bodies bodies, float[] images) {

    public int width() {
        return (int) view.frame()[Layout.WIDTH];
    }

    public int height() {
        return (int) view.frame()[Layout.HEIGHT];
    }

    public int firstRow() {
        return (int) view.frame()[Layout.FIRST_ROW];
    }

    public int rows() {
        return (int) view.frame()[Layout.ROWS];
    }

    /** Number of present bodies without meshes: the first light, the plane and the spheres. */
    public int bodyCount() {
        return (int) view.frame()[Layout.BODIES];
    }

    /** One more than the highest number of a present body, including meshes, but without lights after the first. */
    public int bodyEnd() {
        return bodies.firstMesh() == Layout.NO_MESHES ? bodyCount() : bodies.end();
    }

    /** Number of lights. */
    public int lights() {
        return (int) view.frame()[Layout.LIGHTS];
    }

    /** A light's body. */
    public int light(int index) {
        return (int) bodies.looks()[(int) view.frame()[Layout.LIGHT_TABLE] + index];
    }

    /** Whether a light's body is a sun, which no ray hits. */
    public boolean isSun(int body) {
        return bodies.looks()[Layout.LOOK_STRIDE * body + Layout.LOOK_LIGHT] == Layout.SUN_LIGHT;
    }

    /** Whether a light's body is a spot, which rays outside of its cone pass. */
    public boolean isSpot(int body) {
        return bodies.looks()[Layout.LOOK_STRIDE * body + Layout.LOOK_LIGHT] == Layout.SPOT_LIGHT;
    }

    /** Whether the body is a light. */
    public boolean isLight(int body) {
        return body > Layout.NOTHING && bodies.looks()[Layout.LOOK_STRIDE * body + Layout.LOOK_LIGHT] > 0;
    }

    /** The place of a light's body in the scene's list. */
    public int lightIndex(int body) {
        return IntStream.range(0, lights())
                .filter(index -> light(index) == body)
                .findFirst()
                .orElseThrow();
    }

    /** Whether the one light that the paper's formula has is not enough. */
    public boolean hasSeveralLights() {
        float[] looks = bodies.looks();
        return lights() > 1 || looks[Layout.LOOK_SHARE] != 1 || looks[Layout.LOOK_LIGHT] != Layout.SPHERE_LIGHT;
    }

    public int shadowSamples() {
        return (int) view.frame()[Layout.SHADOW_SAMPLES];
    }

    public int bounces() {
        return (int) view.frame()[Layout.BOUNCES];
    }

    public int samplesPerPixel() {
        return (int) view.frame()[Layout.PIXEL_SAMPLES];
    }

    /** What is rendered: a constant of {@link Views}. */
    public int stageOrView() {
        return view.stageOrView();
    }

    /** In stops: radiance is multiplied by 2^exposure. */
    public double exposure() {
        float scale = view.frame()[Layout.EXPOSURE_SCALE];
        double stops = Math.log(scale) / Math.log(2);
        double rounded = Math.rint(1e6 * stops) / 1e6;
        return (float) Math.pow(2, rounded) == scale ? rounded : stops;
    }

    @SuppressWarnings("EnumOrdinal") // a test checks that the kernel's numbers match the constants' order
    public ToneMap toneMap() {
        return ToneMap.values()[(int) view.frame()[Layout.TONE_MAP]];
    }

    /** Whether 8-bit pixels are sRGB-encoded. */
    public boolean srgb() {
        return view.frame()[Layout.SRGB] > 0;
    }

    /** Place in {@link Bodies#floats} of the root over the spheres that cast shadows. */
    public int shadowRoot() {
        return (int) view.frame()[Layout.SHADOW_ROOT];
    }

    /** Place of the root over the lights that are spheres, other than the first; empty without any. */
    public OptionalInt lightRoot() {
        return view.frame()[Layout.ROOT] == shadowRoot()
                ? OptionalInt.empty()
                : OptionalInt.of(shadowRoot() + Layout.NODE_STRIDE);
    }

    /** Whether paths are traced. */
    public boolean tracesPaths() {
        return view.frame()[Layout.EMITTER_TABLE] > 0;
    }

    /**
     * The kernel's argument {@code variant}: bits of {@link Variant}. They stay the same while spheres are poured
     * (unless two meet in one place), because a device would compile the kernel again. With few spheres the brute-force
     * loop is inlined into the kernel, which the traversal is too large for.
     *
     * @param linear whether the output is linear floats
     */
    public int variant(boolean linear) {
        return (hasFewSpheres() ? 0 : Variant.WALK)
                | (bodies.firstMesh() == Layout.NO_MESHES ? 0 : Variant.MESHES)
                | materials()
                | (tracesPaths() ? Variant.PATH : 0)
                | (hasSeveralLights() ? Variant.LIGHTS : 0)
                | (linear ? Variant.LINEAR : 0)
                | Variant.of(stageOrView());
    }

    private int materials() {
        boolean meshes = bodies.firstMesh() != Layout.NO_MESHES;
        int shown = meshes ? bodies.materials() : bodies.materials() & ~Variant.MASKS;
        int finish = shown & Variant.FINISH;
        // Normals and tangents of a finish are those of maps.
        int traced = shown | Variant.MATERIALS | (finish == 0 ? 0 : Variant.MAPS);
        return tracesPaths() ? traced : shown - finish;
    }

    /**
     * The same picture, without meshes, with leaves of another size in the hierarchy over the spheres.
     *
     * @param mostInLeaf largest number of spheres per leaf, at least 1
     */
    public FrameInput withLeavesOf(int mostInLeaf) {
        float[] places = Arrays.copyOf(bodies.floats(), bodies.spheres());
        int[] spheres = IntStream.range(0, lights())
                .map(this::light)
                .filter(light -> light != Layout.LIGHT && bodies.size(light) > 0 && !isSun(light))
                .toArray();
        float[] floats = SphereHierarchy.of(places, bodyCount(), spheres, mostInLeaf);
        return new FrameInput(view, bodies.withFloats(floats), images);
    }

    /**
     * A band of the picture: only some rows are rendered.
     *
     * @throws IllegalArgumentException if the rows are not in the picture
     */
    public FrameInput band(int firstRow, int rows) {
        if (firstRow < 0 || rows < 1 || firstRow > height() - rows) {
            throw new IllegalArgumentException("rows " + firstRow + " to " + (firstRow + rows) + " of " + height());
        }
        return with(view.withRows(firstRow, rows));
    }

    /**
     * The same view in another size, with all rows.
     *
     * @throws IllegalArgumentException if a side is below 1
     */
    public FrameInput withSize(int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height);
        }
        return with(view.withSize(width, height));
    }

    /**
     * The same picture with a run of consecutive samples from the sequence of pixel samples; number 0 is the pixel's
     * center. The mean of adjacent runs, weighted by their samples, equals one long run.
     *
     * @throws IllegalArgumentException if {@code first} is negative or {@code samples} below 1
     */
    public FrameInput withSamples(int first, int samples) {
        if (first < 0 || samples < 1) {
            throw new IllegalArgumentException(samples + " samples from " + first);
        }
        return with(view.withSamples(first, samples));
    }

    /**
     * Some tiles of this picture. An engine may leave the other pixels as they are, make them black or render them; to
     * be chosen last, after rows and samples.
     *
     * @param wanted for each square of {@link Layout#TILE_SIDE} pixels of the rows, from the top left
     * @throws IllegalArgumentException if that is another number of tiles than the rows have, or too many
     */
    public FrameInput withTiles(boolean[] wanted) {
        if (wanted.length != tilesAcross() * Math.ceilDiv(rows(), Layout.TILE_SIDE)
                || wanted.length > Layout.MOST_TILES) {
            throw new IllegalArgumentException(wanted.length + " tiles for " + width() + " x " + rows() + " pixels");
        }
        return with(view.withTiles(wanted));
    }

    /** Number of tiles beside each other. */
    public int tilesAcross() {
        return Math.ceilDiv(width(), Layout.TILE_SIDE);
    }

    /** Whether a tile is to be rendered; tiles are counted from the top left of the rows. */
    public boolean isWanted(int tile) {
        int tiles = (int) view.frame()[Layout.TILES];
        return tiles == 0 || view.frame()[tiles + tile] > 0;
    }

    /** Number of the first sample in the sequence. */
    public int firstSample() {
        return (int) view.frame()[Layout.FIRST_SAMPLE];
    }

    /**
     * A stage or view of this picture. 8-bit frames show the values as if they were colors; linear frames hold the
     * values themselves.
     */
    public FrameInput showing(StageOrView picture) {
        return with(view.showing(picture));
    }

    /** The same picture with guides of denoising as layers, see {@link #layers}; for linear frames alone. */
    public FrameInput withGuides() {
        return with(new View(view.frame(), Views.GUIDED));
    }

    /**
     * The same picture with guides, and then the light of each group of lights, as layers; for linear frames alone.
     *
     * @param groups of the scene
     */
    public FrameInput withLightLayers(LightGroups groups) {
        float[] looks = bodies.looks();
        float[] grouped = Arrays.copyOf(looks, looks.length + groups.layers().length);
        System.arraycopy(groups.layers(), 0, grouped, looks.length, groups.layers().length);
        float[] frame = view.frame().clone();
        frame[Layout.LIGHT_LAYERS] = groups.names().size();
        frame[Layout.LIGHT_GROUPS] = looks.length;
        return new FrameInput(new View(frame, Views.LAYERED), bodies.withLooks(grouped), images);
    }

    /**
     * Number of layers of a linear frame beside the radiance: albedo and normal if there are guides, then those of
     * light, then alpha if there is no background.
     */
    public int layers() {
        int variant = Variant.of(stageOrView());
        int lights = Views.isLayered(variant) != 0 ? (int) view.frame()[Layout.LIGHT_LAYERS] : 0;
        return (Views.isGuided(variant) != 0 ? Guides.LAYERS : 0) + lights + Views.isCut(variant);
    }

    /**
     * The same picture without its background, for linear frames alone: colors are multiplied by alpha, which is the
     * last layer; to be chosen after guides and layers of light.
     */
    public FrameInput withoutBackground() {
        int cut = stageOrView() == Views.FULL ? Views.CUT : stageOrView() + Views.CUT_GUIDED - Views.GUIDED;
        return with(new View(view.frame(), cut));
    }

    /** Whether the picture has no background. */
    public boolean isCut() {
        return Views.isCut(Variant.of(stageOrView())) != 0;
    }

    private FrameInput with(View newView) {
        return new FrameInput(newView, bodies, images);
    }

    /**
     * Whether the hierarchy is a single leaf, and stays one during a pour, so that code compiled for few spheres stays
     * valid.
     */
    public boolean hasFewSpheres() {
        return lightRoot().isEmpty()
                && bodies.floats()[shadowRoot() + Layout.NODE_SPHERES] >= 0
                && bodies.room() - Layout.FIRST_SPHERE < SphereHierarchy.FEWEST_SPHERES;
    }
}
