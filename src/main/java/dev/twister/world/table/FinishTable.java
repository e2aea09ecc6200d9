package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.scene.Material;
import dev.twister.scene.material.Finish;
import dev.twister.scene.material.ImageMap;
import dev.twister.world.table.MapUse.Content;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.Function;

/** The finishes of the bodies in {@code looks}, each once. */
final class FinishTable {
    /** Places at its multiples are exact as floats up to 2^27. */
    private static final int ALIGNMENT = 8;

    private static final List<Slot> SLOTS = List.of(
            slot(Layout.FINISH_MAPS_COAT, Content.NUMBERS, Finish::clearcoat, Finish.Clearcoat::map),
            slot(Layout.FINISH_MAPS_COAT_ROUGHNESS, Content.NUMBERS, Finish::clearcoat, Finish.Clearcoat::roughnessMap),
            slot(Layout.FINISH_MAPS_COAT_NORMAL, Content.NORMALS, Finish::clearcoat, Finish.Clearcoat::normalMap),
            slot(Layout.FINISH_MAPS_SHEEN, Content.COLOR, Finish::sheen, Finish.Sheen::colorMap),
            slot(Layout.FINISH_MAPS_SHEEN_ROUGHNESS, Content.NUMBERS, Finish::sheen, Finish.Sheen::roughnessMap),
            slot(Layout.FINISH_MAPS_ANISOTROPY, Content.NUMBERS, Finish::anisotropy, Finish.Anisotropy::map),
            slot(Layout.FINISH_MAPS_SPECULAR, Content.NUMBERS, Finish::specular, Finish.Specular::map),
            slot(Layout.FINISH_MAPS_SPECULAR_COLOR, Content.COLOR, Finish::specular, Finish.Specular::colorMap),
            slot(Layout.FINISH_MAPS_FILM, Content.NUMBERS, Finish::film, Finish.Film::map),
            slot(Layout.FINISH_MAPS_FILM_THICKNESS, Content.NUMBERS, Finish::film, Finish.Film::thicknessMap),
            slot(Layout.FINISH_MAPS_THROUGH, Content.NUMBERS, Finish::through, Finish.Through::map),
            slot(Layout.FINISH_MAPS_THROUGH_COLOR, Content.COLOR, Finish::through, Finish.Through::colorMap));

    private final MapTable maps;
    private final SequencedMap<Finish, Integer> numbers = new LinkedHashMap<>();

    /** A map's place in a row, and what is taken from its image. */
    private record Slot(int place, Content content, Function<Finish, Optional<ImageMap>> map) {}

    /** @param maps receives the maps of finishes */
    FinishTable(MapTable maps) {
        this.maps = maps;
    }

    private static <P> Slot slot(
            int place, Content content, Function<Finish, P> part, Function<P, Optional<ImageMap>> map) {
        return new Slot(place, content, part.andThen(map));
    }

    /**
     * Number of the row of a material's finish, from 1 on; 0 without one.
     *
     * @throws IllegalArgumentException if a map is not among the images
     */
    int number(Material material) {
        if (!material.hasFinish()) {
            return 0;
        }
        Finish finish = material.finish();
        SLOTS.forEach(slot ->
                slot.map().apply(finish).ifPresent(map -> maps.use(new MapUse(map.file(), slot.content()))));
        return numbers.computeIfAbsent(finish, _ -> 1 + numbers.size());
    }

    /** What the finishes need of the kernel: bits of {@link Variant}. */
    int variant() {
        return numbers.isEmpty() ? 0 : Variant.FINISH;
    }

    /**
     * Appends the rows, and writes their places into the bodies' looks.
     *
     * @param looks with the rows' numbers
     */
    float[] appendTo(float[] looks, int bodies, MapTexels texels) {
        if (numbers.isEmpty()) {
            return looks;
        }
        int start = Math.ceilDiv(looks.length, ALIGNMENT) * ALIGNMENT;
        float[] all = Arrays.copyOf(looks, start + Layout.FINISH_STRIDE * numbers.size());
        int row = start;
        for (Finish finish : numbers.keySet()) {
            writeNumbers(all, row, finish);
            for (Slot slot : SLOTS) {
                maps.write(all, row + slot.place(), slot.map().apply(finish), slot.content(), texels);
            }
            row += Layout.FINISH_STRIDE;
        }
        for (int at = Layout.LOOK_FINISH; at < Layout.LOOK_STRIDE * bodies; at += Layout.LOOK_STRIDE) {
            all[at] = all[at] > 0 ? start + Layout.FINISH_STRIDE * ((int) all[at] - 1) : 0;
        }
        return all;
    }

    private static void writeNumbers(float[] looks, int row, Finish finish) {
        looks[row + Layout.FINISH_COAT] = (float) finish.clearcoat().part();
        looks[row + Layout.FINISH_COAT_ROUGHNESS] = (float) finish.clearcoat().roughness();
        LookTable.putColor(looks, row + Layout.FINISH_SHEEN, finish.sheen().color());
        looks[row + Layout.FINISH_SHEEN_ROUGHNESS] = (float) finish.sheen().roughness();
        looks[row + Layout.FINISH_ANISOTROPY] = (float) finish.anisotropy().strength();
        looks[row + Layout.FINISH_GRAIN_COSINE] =
                (float) Math.cos(finish.anisotropy().rotation());
        looks[row + Layout.FINISH_GRAIN_SINE] =
                (float) Math.sin(finish.anisotropy().rotation());
        LookTable.putColor(
                looks, row + Layout.FINISH_SPECULAR_COLOR, finish.specular().color());
        looks[row + Layout.FINISH_FILM] = (float) finish.film().part();
        looks[row + Layout.FINISH_FILM_IOR] = (float) finish.film().ior();
        looks[row + Layout.FINISH_FILM_THICKNESS] = (float) finish.film().thickness();
        looks[row + Layout.FINISH_FILM_LEAST] = (float) finish.film().leastThickness();
        looks[row + Layout.FINISH_DISPERSION] = (float) finish.dispersion();
        looks[row + Layout.FINISH_THROUGH] = (float) finish.through().part();
        LookTable.putColor(
                looks, row + Layout.FINISH_THROUGH_COLOR, finish.through().color());
        looks[row + Layout.FINISH_COAT_NORMAL_SCALE] =
                MapTable.scale(finish.clearcoat().normalMap());
    }
}
