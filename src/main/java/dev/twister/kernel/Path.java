package dev.twister.kernel;

/** A path of rays from one that is given to its end. Whoever draws a part of a path by other means may take it up here. */
public final class Path {
    private Path() {}

    /**
     * Follows the path's ray, and adds what it finds to {@link Layout#RADIANCE}. The arrays are {@link Layout}'s.
     *
     * @param path {@link Layout#PATH_LENGTH} floats: the ray, the body that it leaves, the throughput and the radiance so far
     * @param firstBounce how many surfaces the path has left already, in [0, bounces]
     * @param bodies how many there are
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     * @param search {@link Hit#ALL} or {@link Hit#WALK}
     */
    public static void follow(
            float[] path,
            int firstBounce,
            float[] properties,
            float[] places,
            float[] looks,
            float[] hierarchy,
            int bodies,
            float[] sky,
            int[] skyDimensions,
            float[] shadowDisc,
            float[] scratch,
            int search) {
        int bounces = (int) properties[Layout.BOUNCES];
        int goesOn = 1;
        for (int bounce = firstBounce; bounce <= bounces && goesOn != 0; bounce++) {
            int body = Hit.find(path, places, hierarchy, bodies, scratch, search);
            if (body == Layout.NOTHING) {
                Sky.add(path, sky, skyDimensions, properties);
            }
            if (body == Layout.LIGHT) {
                Light.add(path, looks);
            }
            goesOn = 0;
            if (body >= Layout.PLANE) {
                Surface.find(path, body, places);
                Material.find(path, body, looks, properties);
                Light.aim(path, places);
                float visible = Shadow.visible(
                        path, body, properties, places, shadowDisc, hierarchy, Layout.root(bodies), scratch);
                Scatter.shade(path, visible, bounce < bounces ? 0 : 1, properties[Layout.AMBIENT], looks);
                Scatter.reflect(path, body);
                goesOn = path[Layout.THROUGHPUT] > 0f ? 1 : 0;
            }
        }
    }
}
