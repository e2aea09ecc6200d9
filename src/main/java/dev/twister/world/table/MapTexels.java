package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.world.SceneImages;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The panorama and the used maps in one array, and the opacity maps behind the meshes, as the kernel reads them.
 *
 * @param uses the maps in {@code images}
 * @param opacities the maps in {@code meshes}
 * @param plainMeshes without the opacity maps
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts
record MapTexels(
        Optional<SceneImages> source,
        List<MapUse> uses,
        Joined images,
        List<MapUse> opacities,
        float[] plainMeshes,
        Joined meshes) {
    static final MapTexels NONE = new MapTexels(
            Optional.empty(), List.of(), Joined.of(new float[0]), List.of(), new float[0], Joined.of(new float[0]));

    /** Where a map is: the place of its first texel, and whether its texels are packed. */
    record Place(int start, boolean packed) {}

    /** An array with maps at its end. */
    record Joined(float[] floats, Map<MapUse, Place> places) {
        static Joined of(float[] floats) {
            return new Joined(floats, Map.of());
        }
    }

    /**
     * The same arrays, as far as they hold these maps.
     *
     * @param newMeshes the array {@code meshes} of {@link Layout}, without maps
     */
    @SuppressWarnings("ReferenceEquality") // arrays are immutable
    MapTexels changedTo(SceneImages newSource, List<MapUse> newUses, List<MapUse> newOpacities, float[] newMeshes) {
        boolean sameSource = source.equals(Optional.of(newSource));
        return new MapTexels(
                Optional.of(newSource),
                newUses,
                sameSource && uses.equals(newUses)
                        ? images
                        : joined(newSource.sky().radiance(), newSource, newUses),
                newOpacities,
                newMeshes,
                sameSource && plainMeshes == newMeshes && opacities.equals(newOpacities)
                        ? meshes
                        : joined(newMeshes, newSource, newOpacities));
    }

    private static Joined joined(float[] first, SceneImages source, List<MapUse> uses) {
        if (uses.isEmpty()) {
            return Joined.of(first);
        }
        List<MapContent> contents =
                uses.stream().map(use -> MapContent.of(use, source)).toList();
        Map<MapUse, Place> places = new HashMap<>();
        long end = first.length;
        for (int i = 0; i < contents.size(); i++) {
            MapContent content = contents.get(i);
            long start = Math.ceilDiv(end + content.codes().length, (long) Layout.ALIGNMENT) * Layout.ALIGNMENT;
            end = start + content.texels();
            if (end > Integer.MAX_VALUE - Long.BYTES) {
                throw new IllegalArgumentException(
                        "sky and textures take " + end + " floats together; at most " + Integer.MAX_VALUE + " fit");
            }
            places.put(uses.get(i), new Place((int) start, content.isPacked()));
        }
        float[] joined = Arrays.copyOf(first, (int) end);
        for (int i = 0; i < contents.size(); i++) {
            contents.get(i).write(joined, places.get(uses.get(i)).start());
        }
        return new Joined(joined, Map.copyOf(places));
    }

    /** Where a map is in its array. */
    Place place(MapUse use) {
        return images.places().containsKey(use)
                ? images.places().get(use)
                : meshes.places().get(use);
    }
}
