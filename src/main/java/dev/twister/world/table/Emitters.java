package dev.twister.world.table;

import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
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
 * @param sky number of the sky's emitter, from 1 on, or 0
 * @param skyTable place of the sky's probabilities in the images, divided by {@link Layout#ALIGNMENT}
 */
@SuppressWarnings("ArrayRecordComponent") // identity is what counts, see FrameInput
public record Emitters(float[] looks, float[] images, int table, int count, int sky, int skyTable) {
    /** Probability of the sky beside other emitters. */
    private static final double SKY_PART = 0.5;

    /** A body that emits, or one of its triangles. */
    private record Emitter(int body, int instance, int triangle, double area, double power) {}

    /**
     * The tables for the present bodies.
     *
     * @param bodyCount number of present bodies without meshes and further lights
     * @param lights each light's radiance
     * @param images {@code images} of {@link Layout}, the sky first
     * @param sky the panorama
     * @param skyShines whether the sky's strength is above 0
     */
    public static Emitters of(
            Bodies bodies, int bodyCount, List<Rgb> lights, float[] images, Skybox sky, boolean skyShines) {
        float[] looks = bodies.looks().clone();
        int further = lights.size() - 1;
        for (int index = 0; index < lights.size(); index++) {
            int body = index == 0 ? Layout.LIGHT : bodies.room() + index - 1;
            LookTable.putColor(looks, Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION, lights.get(index));
        }
        List<Emitter> emitters = new ArrayList<>();
        EmissionMeans means = new EmissionMeans(looks, bodies.textures(), images);
        addSpheres(bodies, 0, bodyCount, looks, means, emitters);
        addSpheres(bodies, bodies.room(), bodies.room() + further, looks, means, emitters);
        if (bodies.firstMesh() != Layout.NO_MESHES) {
            addTriangles(bodies, looks, means, emitters);
        }
        float[] probabilities =
                skyShines ? SkyProbabilities.of(sky.radiance(), sky.width(), sky.height()) : new float[0];
        boolean shines = probabilities.length > 0;
        int table = looks.length;
        int count = emitters.size() + (shines ? 1 : 0);
        looks = Arrays.copyOf(looks, table + Layout.EMITTER_STRIDE * count);
        double power = emitters.stream().mapToDouble(Emitter::power).sum();
        double part = shines ? 1 - SKY_PART : 1;
        double sum = 0;
        int at = table;
        for (Emitter emitter : emitters) {
            double probability = part * emitter.power() / power;
            sum += probability;
            write(looks, at, emitter, sum, probability);
            at += Layout.EMITTER_STRIDE;
        }
        if (shines) {
            write(looks, at, new Emitter(Layout.NOTHING, -1, -1, 0, 0), 1, 1 - sum);
        } else if (count > 0) {
            looks[at - Layout.EMITTER_STRIDE + Layout.EMITTER_END] = 1;
        }
        int skyTable = shines ? Math.ceilDiv(images.length, Layout.ALIGNMENT) : 0;
        return new Emitters(
                looks,
                shines ? joined(images, skyTable, probabilities) : images,
                table,
                count,
                shines ? count : 0,
                skyTable);
    }

    /** Writes the places of the tables to the values of a frame. */
    public void write(float[] frame) {
        frame[Layout.EMITTER_TABLE] = table;
        frame[Layout.EMITTERS] = count;
        frame[Layout.SKY_EMITTER] = sky;
        frame[Layout.SKY_TABLE] = skyTable;
    }

    private static void addSpheres(
            Bodies bodies, int first, int end, float[] looks, EmissionMeans means, List<Emitter> emitters) {
        for (int body = first; body < end; body++) {
            double radiance = means.of(body);
            if (radiance > 0 && body != Layout.PLANE) {
                double area = 4 * Math.PI * bodies.size(body) * bodies.size(body);
                looks[Layout.LOOK_STRIDE * body + Layout.LOOK_EMITTER] = 1 + emitters.size();
                emitters.add(new Emitter(body, -1, -1, area, radiance * area));
            }
        }
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
                    double area = area(floats, at, bodies.meshes(), triangle);
                    emitters.add(new Emitter(body, instance, triangle, area, radiance * area * sides));
                }
            }
        }
    }

    /** A triangle's area in square meters. */
    private static double area(float[] bodies, int instance, float[] meshes, int triangle) {
        int at = Instance.triangles(bodies, instance) + Layout.TRIANGLE_STRIDE * triangle;
        double[] first = edge(bodies, instance, meshes, at, 1);
        double[] second = edge(bodies, instance, meshes, at, 2);
        double x = first[1] * second[2] - first[2] * second[1];
        double y = first[2] * second[0] - first[0] * second[2];
        double z = first[0] * second[1] - first[1] * second[0];
        return Math.sqrt(x * x + y * y + z * z) / 2;
    }

    private static double[] edge(float[] bodies, int instance, float[] meshes, int triangle, int corner) {
        double[] edge = new double[3];
        for (int row = 0; row < 3; row++) {
            int at = instance + Layout.INSTANCE_TO_WORLD + 4 * row;
            for (int axis = 0; axis < 3; axis++) {
                edge[row] += (double) bodies[at + axis]
                        * (meshes[triangle + 3 * corner + axis] - (double) meshes[triangle + axis]);
            }
        }
        return edge;
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
