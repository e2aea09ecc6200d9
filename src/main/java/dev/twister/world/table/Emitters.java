package dev.twister.world.table;

import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.kernel.SunEmitter;
import dev.twister.scene.Rgb;
import dev.twister.sky.Skybox;
import dev.twister.world.Bodies;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The tables of path tracing, see {@link Layout}.
 *
 * @param looks the bodies' looks with the emitters behind them
 * @param images with the sky's probabilities behind them
 * @param table place of the emitters in the looks
 * @param count number of emitters
 * @param suns number of emitters that are suns; they come last but for the sky
 * @param sky number of the sky's emitter, from 1 on, or 0
 * @param tree place in the looks of the tree over the other emitters, or 0
 * @param skyTable place of the sky's probabilities in the images, divided by {@link Layout#ALIGNMENT}
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Emitters(float[] looks, float[] images, int table, int count, int suns, int sky, int tree, int skyTable) {
    /** A body that emits, or one of its triangles. */
    private record Emitter(int body, int instance, int triangle, double area, EmitterTree.Part part) {}

    private static final double[] TO_ALL = {0, 0, 0};

    /**
     * The tables for the present bodies.
     *
     * @param bodyCount number of present bodies: the first light, the plane and the spheres
     * @param lights each light's radiance
     * @param images {@code images} of {@link Layout}, the sky first
     * @param sky the panorama
     * @param skyShines whether the sky's strength is above 0
     */
    public static Emitters of(
            Bodies bodies, int bodyCount, List<Rgb> lights, float[] images, Skybox sky, boolean skyShines) {
        float[] looks = bodies.looks().clone();
        boolean beginsWithSun = looks[Layout.LOOK_LIGHT] == 0;
        BodyOrder numbers = new BodyOrder(bodies.room() - Layout.FIRST_SPHERE, lights.size(), beginsWithSun);
        for (int index = 0; index < lights.size(); index++) {
            int look = Layout.LOOK_STRIDE * numbers.light(index);
            LookTable.putColor(looks, look + Layout.LOOK_EMISSION, lights.get(index));
        }
        List<Emitter> emitters = new ArrayList<>();
        EmissionMeans means = new EmissionMeans(looks, bodies.textures(), images);
        addSpheres(bodies, 0, bodyCount, looks, means, emitters);
        addSpheres(bodies, bodies.room(), bodies.sphereEnd(), looks, means, emitters);
        if (bodies.firstMesh() != Layout.NO_MESHES) {
            addTriangles(bodies, looks, means, emitters);
        }
        List<Emitter> suns = suns(bodies, looks, means);
        float[] probabilities =
                skyShines ? SkyProbabilities.of(sky.radiance(), sky.width(), sky.height()) : new float[0];
        boolean shines = probabilities.length > 0;
        int table = looks.length;
        int count = emitters.size() + suns.size() + (shines ? 1 : 0);
        looks = Arrays.copyOf(looks, table + Layout.EMITTER_STRIDE * count);
        // Lights, suns and the sky are chosen equally often, as how much of each reaches a point is not known.
        int kinds = (emitters.isEmpty() ? 0 : 1) + (suns.isEmpty() ? 0 : 1) + (shines ? 1 : 0);
        double sum = write(looks, table, emitters, 0, 1.0 / kinds);
        int sunTable = table + Layout.EMITTER_STRIDE * emitters.size();
        sum = write(looks, sunTable, suns, sum, 1.0 / kinds);
        if (shines) {
            Emitter far = new Emitter(Layout.NOTHING, -1, -1, 0, new EmitterTree.Part(TO_ALL, 0, 0, TO_ALL));
            write(looks, table + Layout.EMITTER_STRIDE * (count - 1), far, 1, 1 - sum);
        } else if (count > 0) {
            looks[table + Layout.EMITTER_STRIDE * (count - 1) + Layout.EMITTER_END] = 1;
        }
        int tree = 0;
        if (emitters.size() >= EmitterTree.FEWEST) {
            tree = looks.length;
            looks = Arrays.copyOf(looks, tree + EmitterTree.length(emitters.size()));
            EmitterTree.write(emitters.stream().map(Emitter::part).toList(), looks, table, tree);
        }
        int skyTable = shines ? Math.ceilDiv(images.length, Layout.ALIGNMENT) : 0;
        return new Emitters(
                looks,
                shines ? joined(images, skyTable, probabilities) : images,
                table,
                count,
                suns.size(),
                shines ? count : 0,
                tree,
                skyTable);
    }

    /** Writes the places of the tables to the values of a frame. */
    public void write(float[] frame) {
        frame[Layout.EMITTER_TABLE] = table;
        frame[Layout.EMITTERS] = count;
        frame[Layout.SUNS] = suns;
        frame[Layout.SKY_EMITTER] = sky;
        frame[Layout.LIGHT_TREE] = tree;
        frame[Layout.SKY_TABLE] = skyTable;
    }

    /** The centers of the spheres that the tree holds; none without a tree. */
    float[] placesInTree(Bodies bodies) {
        float[] places = new float[tree > 0 ? 3 * count : 0];
        for (int emitter = 0; emitter < places.length / 3; emitter++) {
            int row = table + Layout.EMITTER_STRIDE * emitter;
            int body = (int) looks[row + Layout.EMITTER_BODY];
            for (int axis = 0; axis < 3 && body > Layout.NOTHING && looks[row + Layout.EMITTER_TRIANGLE] < 0; axis++) {
                places[3 * emitter + axis] = bodies.center(body, axis);
            }
        }
        return places;
    }

    private static void addSpheres(
            Bodies bodies, int first, int end, float[] looks, EmissionMeans means, List<Emitter> emitters) {
        for (int body = first; body < end; body++) {
            double radiance = means.of(body);
            if (radiance > 0 && body != Layout.PLANE && !isSun(body, looks)) {
                double area = 4 * Math.PI * bodies.size(body) * bodies.size(body);
                looks[Layout.LOOK_STRIDE * body + Layout.LOOK_EMITTER] = 1 + emitters.size();
                double[] center = {bodies.center(body, 0), bodies.center(body, 1), bodies.center(body, 2)};
                int look = Layout.LOOK_STRIDE * body;
                boolean isSpot = looks[look + Layout.LOOK_LIGHT] == Layout.SPOT_LIGHT;
                double[] axis = isSpot ? axis(looks, look) : TO_ALL;
                emitters.add(new Emitter(
                        body, -1, -1, area, new EmitterTree.Part(center, bodies.size(body), radiance * area, axis)));
            }
        }
    }

    private static double[] axis(float[] looks, int look) {
        double[] axis = new double[3];
        Arrays.setAll(axis, i -> looks[look + Layout.LOOK_SPOT_AXIS + i]);
        return axis;
    }

    private static boolean isSun(int body, float[] looks) {
        return looks[Layout.LOOK_STRIDE * body + Layout.LOOK_LIGHT] == Layout.SUN_LIGHT;
    }

    /** The suns, whose power is the irradiance. */
    private static List<Emitter> suns(Bodies bodies, float[] looks, EmissionMeans means) {
        List<Emitter> suns = new ArrayList<>();
        for (int body = bodies.room(); body < bodies.sphereEnd(); body++) {
            double sine = Math.max(looks[Layout.LOOK_STRIDE * body + Layout.LOOK_SUN_SINE], SunEmitter.LEAST_SINE);
            double power = means.of(body) * sine * sine;
            if (isSun(body, looks) && power > 0) {
                suns.add(new Emitter(body, -1, -1, 0, new EmitterTree.Part(TO_ALL, 0, power, TO_ALL)));
            }
        }
        return suns;
    }

    private static void addTriangles(Bodies bodies, float[] looks, EmissionMeans means, List<Emitter> emitters) {
        float[] floats = bodies.floats();
        int first = Instance.at(0, bodies.instances(), floats);
        for (int instance = 0; first + Layout.INSTANCE_STRIDE * instance < floats.length; instance++) {
            int at = first + Layout.INSTANCE_STRIDE * instance;
            int body = (int) floats[at + Layout.INSTANCE_BODY];
            double radiance = means.of(body);
            if (radiance > 0) {
                int look = Layout.LOOK_STRIDE * body;
                int sides = looks[look + Layout.LOOK_ONE_SIDED] > 0 ? 1 : 2;
                looks[look + Layout.LOOK_EMITTER] = 1 + emitters.size();
                int triangles = (int) floats[at + Layout.INSTANCE_TRIANGLES];
                for (int triangle = 0; triangle < triangles; triangle++) {
                    double[][] corners = corners(floats, at, bodies.meshes(), triangle);
                    double[] normal = cross(corners);
                    double twice = Math.sqrt(EmitterTree.dot(normal, normal));
                    double power = radiance * twice / 2 * sides;
                    emitters.add(new Emitter(
                            body, instance, triangle, twice / 2, part(corners, normal, twice, power, sides)));
                }
            }
        }
    }

    private static EmitterTree.Part part(double[][] corners, double[] normal, double length, double power, int sides) {
        double[] center = new double[3];
        double[] axis = new double[3];
        for (int i = 0; i < 3; i++) {
            center[i] = (corners[0][i] + corners[1][i] + corners[2][i]) / 3;
            axis[i] = sides == 1 && length > 0 ? normal[i] / length : 0;
        }
        double squared = 0;
        for (double[] corner : corners) {
            double[] away = {corner[0] - center[0], corner[1] - center[1], corner[2] - center[2]};
            squared = Math.max(squared, EmitterTree.dot(away, away));
        }
        return new EmitterTree.Part(center, Math.sqrt(squared), power, axis);
    }

    private static double[][] corners(float[] bodies, int instance, float[] meshes, int triangle) {
        int at = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * triangle;
        double[][] corners = new double[3][3];
        for (int corner = 0; corner < 3; corner++) {
            for (int row = 0; row < 3; row++) {
                int place = instance + Layout.INSTANCE_TO_WORLD + 4 * row;
                corners[corner][row] = bodies[place + 3];
                for (int axis = 0; axis < 3; axis++) {
                    corners[corner][row] += (double) bodies[place + axis] * meshes[at + 3 * corner + axis];
                }
            }
        }
        return corners;
    }

    /** Twice a triangle's area, along its normal. */
    private static double[] cross(double[][] corners) {
        double[] first = new double[3];
        double[] second = new double[3];
        for (int i = 0; i < 3; i++) {
            first[i] = corners[1][i] - corners[0][i];
            second[i] = corners[2][i] - corners[0][i];
        }
        return new double[] {
            first[1] * second[2] - first[2] * second[1],
            first[2] * second[0] - first[0] * second[2],
            first[0] * second[1] - first[1] * second[0]
        };
    }

    /**
     * Writes emitters, one of which is chosen with some probability in all.
     *
     * @param before sum of the probabilities of the emitters before
     * @return the sum with these
     */
    private static double write(float[] looks, int start, List<Emitter> emitters, double before, double part) {
        double power =
                emitters.stream().mapToDouble(emitter -> emitter.part().power()).sum();
        double sum = before;
        int at = start;
        for (Emitter emitter : emitters) {
            double probability = part * emitter.part().power() / power;
            sum += probability;
            write(looks, at, emitter, sum, probability);
            at += Layout.EMITTER_STRIDE;
        }
        return sum;
    }

    private static void write(float[] looks, int at, Emitter emitter, double sum, double probability) {
        looks[at + Layout.EMITTER_END] = (float) sum;
        looks[at + Layout.EMITTER_PROBABILITY] = (float) probability;
        looks[at + Layout.EMITTER_BODY] = emitter.body();
        looks[at + Layout.EMITTER_INSTANCE] = emitter.instance();
        looks[at + Layout.EMITTER_TRIANGLE] = emitter.triangle();
        looks[at + Layout.EMITTER_AREA] = (float) emitter.area();
    }

    private static float[] joined(float[] images, int skyTable, float[] probabilities) {
        float[] joined = Arrays.copyOf(images, Layout.ALIGNMENT * skyTable + probabilities.length);
        System.arraycopy(probabilities, 0, joined, Layout.ALIGNMENT * skyTable, probabilities.length);
        return joined;
    }

    /** The mean luminance that bodies emit, with their emission maps. */
    private static final class EmissionMeans {
        private final float[] looks;
        private final int maps;
        private final float[] images;
        private final Map<Integer, double[]> meanByStart = new HashMap<>();

        /**
         * @param looks with the emission of lights, too
         * @param maps place of the maps' table in the looks
         */
        EmissionMeans(float[] looks, int maps, float[] images) {
            this.looks = looks;
            this.maps = maps;
            this.images = images;
        }

        /** The mean over a body's surface; 0 if it emits nothing. */
        double of(int body) {
            int emission = Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION;
            double whole = SkyProbabilities.luminance(looks, emission);
            int number = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_MAPS];
            int map = maps + Layout.MAPS_STRIDE * (number - 1) + Layout.MAPS_EMISSION;
            if (whole == 0 || number == 0 || looks[map + Layout.MAP_WIDTH] == 0) {
                return whole;
            }
            double[] mean = meanByStart.computeIfAbsent((int) looks[map + Layout.MAP_START], _ -> mean(map));
            float[] mapped = new float[mean.length];
            for (int channel = 0; channel < mapped.length; channel++) {
                mapped[channel] = (float) (looks[emission + channel] * mean[channel]);
            }
            return SkyProbabilities.luminance(mapped, 0);
        }

        private double[] mean(int map) {
            int start = Layout.ALIGNMENT * (int) looks[map + Layout.MAP_START];
            int width = (int) looks[map + Layout.MAP_WIDTH];
            int height = (int) looks[map + Layout.MAP_HEIGHT];
            int count = width * height;
            double[] mean = new double[Layout.TEXEL_STRIDE];
            boolean packed = (int) looks[map + Layout.MAP_SAMPLER] / Layout.SAMPLER_PACKED % 2 == 1;
            for (int i = 0; i < Layout.TEXEL_STRIDE * count; i++) {
                int channel = i % Layout.TEXEL_STRIDE;
                mean[channel] += images[packed ? code(start, i) : start + i] / (double) count;
            }
            return mean;
        }

        /** The place of what a packed texel's code stands for. */
        private int code(int start, int i) {
            int texel = (int) images[start + i / Layout.TEXEL_STRIDE];
            return start - Layout.CODES + ((texel >> (8 * (i % Layout.TEXEL_STRIDE))) & 255);
        }
    }
}
