package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.scene.Material;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Sampler;
import dev.twister.world.SceneImages;
import dev.twister.world.table.MapUse.Content;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.SequencedSet;

/** The table of maps that {@link Layout} describes, filled material by material. */
final class MapTable {
    private final SceneImages images;
    private final SequencedMap<Row, Integer> rows = new LinkedHashMap<>();
    private final SequencedSet<MapUse> uses = new LinkedHashSet<>();
    private final SequencedSet<MapUse> opacities = new LinkedHashSet<>();

    /** What a row is made of. */
    private record Row(Optional<Path> texture, Maps maps, Alpha alpha, boolean unlit, boolean vertexColors) {
        boolean isNone() {
            return texture.isEmpty()
                    && maps.withTexture(Sampler.DEFAULT).equals(Maps.NONE)
                    && alpha.mode() == Alpha.Mode.OPAQUE
                    && !unlit
                    && !vertexColors;
        }

        /** Whether it has nothing but a texture that repeats. */
        boolean isTexture() {
            return maps.equals(Maps.NONE) && alpha.mode() == Alpha.Mode.OPAQUE && !unlit && !vertexColors;
        }
    }

    MapTable(SceneImages images) {
        this.images = images;
    }

    /**
     * Number of a material's row, from 1 on; 0 if it has no maps. Only meshes have opacity.
     *
     * @throws IllegalArgumentException if a map is not among the images
     */
    int row(Material material) {
        return row(new Row(material.texture(), material.maps().withoutAlpha(), Alpha.OPAQUE, material.unlit(), false));
    }

    /** As above, for a mesh. */
    int row(MeshBody mesh) {
        Material material = mesh.material();
        Optional<ImageMap> opacity = opacityMap(material);
        boolean varies = opacity.isPresent() || mesh.vertexColors();
        Alpha alpha = material.alpha();
        boolean opaque = switch (alpha.mode()) {
            case OPAQUE -> true;
            case MASK -> !varies && alpha.factor() >= alpha.cutoff();
            case BLEND -> !varies && alpha.factor() >= 1;
        };
        Maps maps = material.maps();
        return row(new Row(
                material.texture(),
                opacity.filter(_ -> !opaque).map(maps::withAlpha).orElseGet(maps::withoutAlpha),
                opaque ? Alpha.OPAQUE : alpha,
                material.unlit(),
                mesh.vertexColors()));
    }

    private Optional<ImageMap> opacityMap(Material material) {
        return material.maps()
                .alpha()
                .or(() -> material.texture()
                        .filter(file -> {
                            checkRead(file);
                            return !images.textureByFile().get(file).isOpaque();
                        })
                        .map(file -> new ImageMap(file, material.maps().texture(), 1)));
    }

    private int row(Row row) {
        if (row.isNone()) {
            return 0;
        }
        use(row);
        return rows.computeIfAbsent(row, _ -> 1 + rows.size());
    }

    private void use(Row row) {
        row.texture().ifPresent(file -> use(new MapUse(file, Content.COLOR)));
        Maps maps = row.maps();
        maps.emission().ifPresent(map -> use(new MapUse(map.file(), Content.COLOR)));
        maps.roughness().ifPresent(map -> use(new MapUse(map.file(), Content.NUMBERS)));
        maps.metallic().ifPresent(map -> use(new MapUse(map.file(), Content.NUMBERS)));
        maps.normal().ifPresent(map -> use(new MapUse(map.file(), Content.NORMALS)));
        maps.occlusion().ifPresent(map -> use(new MapUse(map.file(), Content.NUMBERS)));
        maps.transmission().ifPresent(map -> use(new MapUse(map.file(), Content.NUMBERS)));
        maps.alpha().ifPresent(map -> {
            checkRead(map.file());
            opacities.add(opacity(row, map));
        });
    }

    /** Adds a map that something beside the rows has. */
    void use(MapUse use) {
        checkRead(use.file());
        uses.add(use);
    }

    private static MapUse opacity(Row row, ImageMap map) {
        return new MapUse(map.file(), row.texture().equals(Optional.of(map.file())) ? Content.ALPHA : Content.RED);
    }

    private void checkRead(Path file) {
        if (!images.textureByFile().containsKey(file)) {
            throw new IllegalArgumentException("the texture " + file + " was not read");
        }
    }

    /** The maps in {@code images}. */
    List<MapUse> uses() {
        return List.copyOf(uses);
    }

    /** The opacity maps behind the meshes. */
    List<MapUse> opacities() {
        return List.copyOf(opacities);
    }

    /** What the rows need of the kernel: bits of {@link Variant}. */
    int variant() {
        boolean plain = rows.keySet().stream().allMatch(Row::isTexture);
        boolean opaque = rows.keySet().stream().allMatch(row -> row.alpha().mode() == Alpha.Mode.OPAQUE);
        return (plain ? 0 : Variant.MAPS) | (opaque ? 0 : Variant.MASKS);
    }

    /** The array {@code looks} of {@link Layout}: the bodies' looks, then this table. */
    float[] withTable(float[] looks, MapTexels texels) {
        float[] extended = Arrays.copyOf(looks, looks.length + Layout.MAPS_STRIDE * rows.size());
        int at = looks.length;
        for (Row row : rows.keySet()) {
            write(extended, at, row, texels);
            at += Layout.MAPS_STRIDE;
        }
        return extended;
    }

    private void write(float[] looks, int at, Row row, MapTexels texels) {
        Maps maps = row.maps();
        Optional<ImageMap> color = row.texture().map(file -> new ImageMap(file, maps.texture(), 1));
        write(looks, at + Layout.MAPS_COLOR, color, Content.COLOR, texels);
        write(looks, at + Layout.MAPS_EMISSION, maps.emission(), Content.COLOR, texels);
        write(looks, at + Layout.MAPS_ROUGHNESS, maps.roughness(), Content.NUMBERS, texels);
        write(looks, at + Layout.MAPS_METALLIC, maps.metallic(), Content.NUMBERS, texels);
        write(looks, at + Layout.MAPS_NORMAL, maps.normal(), Content.NORMALS, texels);
        write(looks, at + Layout.MAPS_OCCLUSION, maps.occlusion(), Content.NUMBERS, texels);
        write(looks, at + Layout.MAPS_TRANSMISSION, maps.transmission(), Content.NUMBERS, texels);
        maps.alpha().ifPresent(map -> write(looks, at + Layout.MAPS_ALPHA, map, opacity(row, map), texels));
        looks[at + Layout.MAPS_NORMAL_SCALE] = scale(maps.normal());
        looks[at + Layout.MAPS_OCCLUSION_STRENGTH] = scale(maps.occlusion());
        looks[at + Layout.MAPS_ALPHA_FACTOR] = (float) row.alpha().factor();
        looks[at + Layout.MAPS_CUTOFF] = switch (row.alpha().mode()) {
            case OPAQUE -> Layout.OPAQUE;
            case MASK -> (float) row.alpha().cutoff();
            case BLEND -> Layout.BLENDED;
        };
        looks[at + Layout.MAPS_VERTEX_COLORS] = row.vertexColors() ? 1 : 0;
        looks[at + Layout.MAPS_UNLIT] = row.unlit() ? 1 : 0;
    }

    static float scale(Optional<ImageMap> map) {
        return (float) map.map(ImageMap::scale).orElse(1.0).doubleValue();
    }

    /** Writes a map, or leaves its place as it is if there is none. */
    void write(float[] looks, int at, Optional<ImageMap> map, Content content, MapTexels texels) {
        map.ifPresent(present -> write(looks, at, present, new MapUse(present.file(), content), texels));
    }

    @SuppressWarnings("EnumOrdinal") // a test checks that the kernel's numbers match the constants' order
    private void write(float[] looks, int at, ImageMap map, MapUse use, MapTexels texels) {
        MapTexels.Place place = texels.place(use);
        int start = place.start() / Layout.ALIGNMENT;
        looks[at + Layout.MAP_START] = start;
        looks[at + Layout.MAP_WIDTH] = use.image(images).width();
        looks[at + Layout.MAP_HEIGHT] = use.image(images).height();
        Sampler sampler = map.sampler();
        looks[at + Layout.MAP_SAMPLER] = sampler.across().ordinal()
                + Layout.SAMPLER_DOWN * sampler.down().ordinal()
                + (sampler.nearest() ? Layout.SAMPLER_NEAREST : 0)
                + (place.packed() ? Layout.SAMPLER_PACKED : 0)
                + Layout.SAMPLER_COORDINATES * sampler.coordinates();
    }
}
