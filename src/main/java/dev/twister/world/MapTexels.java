package dev.twister.world;

import dev.twister.kernel.Layout;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
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
        float[] images,
        List<MapUse> opacities,
        float[] plainMeshes,
        float[] meshes) {
    static final MapTexels NONE =
            new MapTexels(Optional.empty(), List.of(), new float[0], List.of(), new float[0], new float[0]);

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

    private static float[] joined(float[] first, SceneImages source, List<MapUse> uses) {
        if (uses.isEmpty()) {
            return first;
        }
        List<Long> starts = starts(first.length, source, uses);
        MapUse last = uses.getLast();
        long length = starts.getLast() + last.length(source);
        if (length > Integer.MAX_VALUE - Long.BYTES) {
            throw new IllegalArgumentException("sky and textures have " + length / Layout.TEXEL_STRIDE
                    + " texels together; at most " + Integer.MAX_VALUE / Layout.TEXEL_STRIDE + " fit");
        }
        float[] joined = Arrays.copyOf(first, (int) length);
        for (int i = 0; i < uses.size(); i++) {
            float[] texels = MapContent.of(uses.get(i), source);
            System.arraycopy(texels, 0, joined, starts.get(i).intValue(), texels.length);
        }
        return joined;
    }

    private static List<Long> starts(int firstLength, SceneImages source, List<MapUse> uses) {
        List<Long> starts = new ArrayList<>();
        long end = firstLength;
        for (MapUse use : uses) {
            long start = (end + Layout.ALIGNMENT - 1) / Layout.ALIGNMENT * Layout.ALIGNMENT;
            starts.add(start);
            end = start + use.length(source);
        }
        return starts;
    }

    /** Place of a map's first texel in its array. */
    int start(MapUse use) {
        SceneImages from = source.orElseThrow();
        int image = uses.indexOf(use);
        return (image >= 0
                        ? starts(from.sky().radiance().length, from, uses).get(image)
                        : starts(plainMeshes.length, from, opacities).get(opacities.indexOf(use)))
                .intValue();
    }
}
