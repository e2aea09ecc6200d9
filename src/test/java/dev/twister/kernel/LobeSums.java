package dev.twister.kernel;

import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.table.LookTable;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;

/**
 * Integrals over all directions of what {@link Lobes#evaluate} says of a surface.
 *
 * @param density of the directions; 1 if all are of lobes that are not mirror-like
 * @param scattered {@code f * |cos|} per channel
 */
record LobeSums(double density, List<Double> scattered) {
    /** @param path after {@link Lobes#prepare} */
    static LobeSums of(float[] path, float[] looks, int variant, int tries, Random random) {
        double whole = 4 * Math.PI / tries;
        double density = 0;
        double[] scattered = new double[3];
        for (int i = 0; i < tries; i++) {
            double z = 2 * random.nextDouble() - 1;
            double turn = 2 * Math.PI * random.nextDouble();
            double level = Math.sqrt(1 - z * z);
            float x = (float) (level * Math.cos(turn));
            float y = (float) (level * Math.sin(turn));
            density += whole * Lobes.evaluate(path, x, y, (float) z, looks, variant);
            for (int channel = 0; channel < 3; channel++) {
                scattered[channel] += whole * path[Layout.SCATTERED + channel];
            }
        }
        return new LobeSums(density, DoubleStream.of(scattered).boxed().toList());
    }

    /** Looks in which {@link Layout#FIRST_SPHERE} has a material. */
    static float[] looks(LookTable table, Material material) {
        table.put(
                Lights.of(Light.of(new Vector3(0, 9, 0), 1, new Rgb(1, 1, 1))),
                Ground.of(1, 0, new Rgb(0, 0, 0), new Rgb(0, 0, 0), 0),
                List.of(Sphere.of(new Vector3(0, 0, 0), 1, material)),
                List.of(),
                new float[0],
                SceneImages.of(new Skybox(1, 1, new float[] {1, 1, 1})));
        return table.looks();
    }
}
