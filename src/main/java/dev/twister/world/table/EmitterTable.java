package dev.twister.world.table;

import dev.twister.scene.Mesh;
import dev.twister.scene.Rgb;
import dev.twister.sky.Skybox;
import dev.twister.world.Bodies;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** The tables of path tracing; the same ones as long as what they are made of is the same. */
public final class EmitterTable {
    private Optional<Source> source = Optional.empty();
    private Optional<Emitters> emitters = Optional.empty();
    private float[] places = {};

    /** What the tables depend on, beside the places of the spheres in a tree. */
    @SuppressWarnings("ArrayRecordComponent") // an array's identity is what counts
    private record Source(
            float[] looks, float[] images, int bodyCount, List<Mesh> meshes, List<Rgb> lights, boolean sky) {}

    /**
     * The tables for the present bodies.
     *
     * @param meshes the scene's meshes, which are where the bodies have them
     * @param lights each light's radiance
     */
    public Emitters of(
            Bodies bodies,
            int bodyCount,
            List<Mesh> meshes,
            List<Rgb> lights,
            float[] images,
            Skybox sky,
            boolean skyShines) {
        Optional<Source> now = Optional.of(new Source(bodies.looks(), images, bodyCount, meshes, lights, skyShines));
        boolean same = source.equals(now)
                && Arrays.equals(places, emitters.orElseThrow().placesInTree(bodies));
        if (!same) {
            source = now;
            Emitters made = Emitters.of(bodies, bodyCount, lights, images, sky, skyShines);
            emitters = Optional.of(made);
            places = made.placesInTree(bodies);
        }
        return emitters.orElseThrow();
    }
}
