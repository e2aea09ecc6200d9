package dev.twister.world.table;

import dev.twister.kernel.DirectionalAlbedo;
import dev.twister.kernel.Layout;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SequencedMap;
import java.util.stream.IntStream;

/** The tables of {@link DirectionalAlbedo} in {@code looks}, for the indices of refraction of a scene. */
final class AlbedoTables {
    /** Indices within half a step share a table; 1.5, glass, has its own. */
    private static final double STEP = Math.log(1.01);

    private static final double GLASS = 1.5;

    /** Facets by which an albedo is integrated, a Fibonacci lattice. */
    private static final int FACETS = 377;

    private static final int LATTICE = 233;
    private static final double LEAST_COSINE = 1e-4;

    /** Of the directions of the lattice's facets about the normal. */
    private static final double[] TURN_COSINES =
            IntStream.range(0, FACETS).mapToDouble(i -> Math.cos(turn(i))).toArray();

    private static final double[] TURN_SINES =
            IntStream.range(0, FACETS).mapToDouble(i -> Math.sin(turn(i))).toArray();

    private static final int COAT_MAP = Layout.FINISH_MAPS_COAT_ROUGHNESS;
    private static final int SHEEN_MAP = Layout.FINISH_MAPS_SHEEN_ROUGHNESS;

    /** By the number of steps from glass. */
    private final Map<Integer, Rows> computed = new HashMap<>();

    private final Rows sheen = new Rows(SheenTables.TABLES);

    /** Tables of which the rows of some roughnesses are filled. */
    private static final class Rows {
        final float[] tables;
        final BitSet filled = new BitSet();

        Rows(int count) {
            tables = new float[count * DirectionalAlbedo.TABLE_LENGTH];
        }

        /** Those that are needed and not yet filled, which are now to be. */
        BitSet missing(BitSet needed) {
            BitSet missing = (BitSet) needed.clone();
            missing.andNot(filled);
            filled.or(needed);
            return missing;
        }

        /** The rows alone that are needed, so that the same scene always has the same tables. */
        float[] only(BitSet needed) {
            float[] only = new float[tables.length];
            int means = DirectionalAlbedo.COSINES * DirectionalAlbedo.ROUGHNESSES;
            for (int table = 0; table < tables.length; table += DirectionalAlbedo.TABLE_LENGTH) {
                int first = table;
                needed.stream().forEach(row -> {
                    int at = first + row * DirectionalAlbedo.COSINES;
                    System.arraycopy(tables, at, only, at, DirectionalAlbedo.COSINES);
                    only[first + means + row] = tables[first + means + row];
                });
            }
            return only;
        }
    }

    /** Appends the tables that the bodies need, and writes their places into the bodies' looks and finishes. */
    float[] appendTo(float[] looks, int bodies) {
        SequencedMap<Integer, BitSet> needed = new LinkedHashMap<>();
        BitSet sheens = new BitSet();
        for (int look = 0; look < Layout.LOOK_STRIDE * bodies; look += Layout.LOOK_STRIDE) {
            if (looks[look + Layout.LOOK_FRESNEL] > 0) {
                BitSet rows = needed.computeIfAbsent(steps(looks, look), _ -> new BitSet());
                need(rows, looks[look + Layout.LOOK_ROUGHNESS], hasRoughnessMap(looks, look, bodies));
            }
            int finish = (int) looks[look + Layout.LOOK_FINISH];
            if (finish > 0) {
                if (looks[finish + Layout.FINISH_COAT] > 0) {
                    BitSet rows = needed.computeIfAbsent(0, _ -> new BitSet());
                    need(rows, looks[finish + Layout.FINISH_COAT_ROUGHNESS], hasMap(looks, finish, COAT_MAP));
                }
                if (hasSheen(looks, finish)) {
                    need(sheens, looks[finish + Layout.FINISH_SHEEN_ROUGHNESS], hasMap(looks, finish, SHEEN_MAP));
                }
            }
        }
        Map<Integer, Integer> places = new HashMap<>();
        float[] all = looks;
        for (Map.Entry<Integer, BitSet> entry : needed.entrySet()) {
            places.put(entry.getKey(), all.length);
            all = append(all, tables(entry.getKey(), entry.getValue()));
        }
        int sheenPlace = all.length;
        if (!sheens.isEmpty()) {
            SheenTables.fill(sheen.tables, sheen.missing(sheens));
            all = append(all, sheen.only(sheens));
        }
        for (int look = 0; look < Layout.LOOK_STRIDE * bodies; look += Layout.LOOK_STRIDE) {
            if (looks[look + Layout.LOOK_FRESNEL] > 0) {
                all[look + Layout.LOOK_ALBEDOS] = places.get(steps(looks, look));
            }
            int finish = (int) looks[look + Layout.LOOK_FINISH];
            if (finish > 0) {
                // The place of any table where there is no coat or sheen.
                int coat = places.getOrDefault(0, (int) all[look + Layout.LOOK_ALBEDOS]);
                all[finish + Layout.FINISH_COAT_ALBEDO] =
                        coat + DirectionalAlbedo.COAT * DirectionalAlbedo.TABLE_LENGTH;
                all[finish + Layout.FINISH_SHEEN_ALBEDO] = sheens.isEmpty() ? coat : sheenPlace;
            }
        }
        return all;
    }

    /** The maps' table follows the bodies. */
    private static boolean hasRoughnessMap(float[] looks, int look, int bodies) {
        int maps = (int) looks[look + Layout.LOOK_MAPS];
        int row = Layout.LOOK_STRIDE * bodies + Layout.MAPS_STRIDE * (maps - 1);
        return maps > 0 && looks[row + Layout.MAPS_ROUGHNESS + Layout.MAP_WIDTH] > 0;
    }

    private static int steps(float[] looks, int look) {
        return (int) Math.round(Math.log(looks[look + Layout.LOOK_IOR] / GLASS) / STEP);
    }

    /** Adds the rows on both sides of a roughness, and those of smooth surfaces; all if a map varies it. */
    private static void need(BitSet rows, float roughness, boolean mapped) {
        int last = DirectionalAlbedo.ROUGHNESSES - 1;
        int upper = Math.min((int) (roughness * last), last - 1);
        rows.set(0, 2);
        rows.set(mapped ? 0 : upper, mapped ? last + 1 : upper + 2);
    }

    private static float[] append(float[] looks, float[] tables) {
        float[] all = Arrays.copyOf(looks, looks.length + tables.length);
        System.arraycopy(tables, 0, all, looks.length, tables.length);
        return all;
    }

    private float[] tables(int steps, BitSet needed) {
        Rows rows = computed.computeIfAbsent(steps, _ -> new Rows(DirectionalAlbedo.TABLES));
        fill(rows.tables, rows.missing(needed), GLASS * Math.exp(steps * STEP));
        return rows.only(needed);
    }

    private static boolean hasMap(float[] looks, int finish, int map) {
        return looks[finish + map + Layout.MAP_WIDTH] > 0;
    }

    private static boolean hasSheen(float[] looks, int finish) {
        int color = finish + Layout.FINISH_SHEEN;
        return looks[color] + looks[color + 1] + looks[color + 2] > 0;
    }

    private static void fill(float[] tables, BitSet rows, double ior) {
        int[] places = rows.stream()
                .flatMap(row -> IntStream.range(0, DirectionalAlbedo.COSINES)
                        .map(column -> row * DirectionalAlbedo.COSINES + column))
                .toArray();
        Arrays.stream(places).parallel().forEach(place -> {
            int row = place / DirectionalAlbedo.COSINES;
            double root = (place - DirectionalAlbedo.COSINES * row) / (DirectionalAlbedo.COSINES - 1.0);
            double roughness = row / (DirectionalAlbedo.ROUGHNESSES - 1.0);
            double[] albedos = albedos(roughness * roughness, Math.max(root * root, LEAST_COSINE), ior);
            for (int table = 0; table < DirectionalAlbedo.TABLES; table++) {
                tables[table * DirectionalAlbedo.TABLE_LENGTH + place] = (float) albedos[table];
            }
        });
        int means = DirectionalAlbedo.COSINES * DirectionalAlbedo.ROUGHNESSES;
        for (int table = 0; table < tables.length; table += DirectionalAlbedo.TABLE_LENGTH) {
            int first = table;
            rows.stream()
                    .forEach(
                            row -> tables[first + means + row] = mean(tables, first + row * DirectionalAlbedo.COSINES));
        }
    }

    /** The integral of a row, linear over the root u of the cosine, times 4 u^3 du. */
    private static float mean(float[] tables, int row) {
        double sum = 0;
        for (int column = 0; column + 1 < DirectionalAlbedo.COSINES; column++) {
            double from = column / (DirectionalAlbedo.COSINES - 1.0);
            double to = (column + 1) / (DirectionalAlbedo.COSINES - 1.0);
            double slope = (tables[row + column + 1] - tables[row + column]) / (to - from);
            double start = tables[row + column] - slope * from;
            sum += start * (Math.pow(to, 4) - Math.pow(from, 4)) + slope * 0.8 * (Math.pow(to, 5) - Math.pow(from, 5));
        }
        return (float) sum;
    }

    /** Sums over visible facets (Dupuy and Benyoub 2023), in the order of the tables. */
    private static double[] albedos(double alpha, double cosine, double ior) {
        double sine = Math.sqrt(1 - cosine * cosine);
        double length = Math.hypot(alpha * sine, cosine);
        double viewX = alpha * sine / length;
        double viewZ = cosine / length;
        double entering = 1 + lambda(alpha, cosine);
        double[] sums = new double[DirectionalAlbedo.TABLES];
        for (int i = 0; i < FACETS; i++) {
            double height = (i + 0.5) / FACETS;
            double z = (1 - height) * (1 + viewZ) - viewZ;
            double radius = Math.sqrt(Math.max(0, 1 - z * z));
            double facetX = alpha * (viewX + radius * TURN_COSINES[i]);
            double facetY = alpha * radius * TURN_SINES[i];
            double facetZ = viewZ + z;
            double scale = 1 / Math.sqrt(facetX * facetX + facetY * facetY + facetZ * facetZ);
            double dot = (sine * facetX + cosine * facetZ) * scale;
            double normal = facetZ * scale;
            double reflected = weight(entering, alpha, 2 * dot * normal - cosine);
            sums[DirectionalAlbedo.MIRROR] += reflected;
            for (int inside = 0; inside < 2; inside++) {
                double ratio = inside == 0 ? 1 / ior : ior;
                double squared = 1 - ratio * ratio * (1 - dot * dot);
                double passed = Math.sqrt(Math.max(0, squared));
                double fresnel = squared > 0 ? fresnel(dot, passed, ratio) : 1;
                double out = ratio * (cosine - dot * normal) + passed * normal;
                sums[DirectionalAlbedo.COAT] += inside == 0 ? fresnel * reflected : 0;
                sums[DirectionalAlbedo.GLASS + inside] +=
                        fresnel * reflected + (1 - fresnel) * weight(entering, alpha, out);
            }
        }
        for (int table = 0; table < sums.length; table++) {
            sums[table] /= FACETS;
        }
        return sums;
    }

    private static double fresnel(double cosine, double passed, double ratio) {
        double across = (ratio * cosine - passed) / (ratio * cosine + passed);
        double along = (cosine - ratio * passed) / (cosine + ratio * passed);
        return (across * across + along * along) / 2;
    }

    private static double turn(int facet) {
        return Math.PI * (facet * LATTICE % FACETS + 0.5) / FACETS;
    }

    /**
     * G2 / G1 of Smith's height-correlated masking and shadowing.
     *
     * @param entering 1 and the lambda of the direction that the light comes from
     */
    private static double weight(double entering, double alpha, double cosineOut) {
        return cosineOut > 0 ? entering / (entering + lambda(alpha, cosineOut)) : 0;
    }

    private static double lambda(double alpha, double cosine) {
        return (Math.sqrt(1 + alpha * alpha * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
    }
}
