package dev.twister.oracle;

import dev.twister.sky.Skybox;
import java.util.Random;

/** Small panoramas of unusual sizes with strong contrast. */
final class RandomSkies {
    private static final int[][] AWKWARD_SIZES = {{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 5}};

    private RandomSkies() {}

    static Skybox sky(Random random) {
        int[] awkward = AWKWARD_SIZES[random.nextInt(AWKWARD_SIZES.length)];
        boolean isAwkward = random.nextInt(3) == 0;
        int width = isAwkward ? awkward[0] : 1 + random.nextInt(17);
        int height = isAwkward ? awkward[1] : 1 + random.nextInt(9);
        float[] radiance = new float[3 * width * height];
        for (int i = 0; i < radiance.length; i++) {
            radiance[i] = switch (random.nextInt(4)) {
                case 0 -> 0;
                case 1 -> 50 * random.nextFloat();
                default -> random.nextFloat();
            };
        }
        return new Skybox(width, height, radiance);
    }
}
