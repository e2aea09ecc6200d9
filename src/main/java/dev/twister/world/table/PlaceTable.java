package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.scene.Ground;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.world.SceneMeshes;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The array {@code bodies} of {@link Layout}. The hierarchy over the spheres is built again only if spheres have
 * changed, moved or been poured.
 */
public final class PlaceTable {
    /** Beyond all that is seen, in no direction of note. */
    private static final Vector3 NOWHERE = new Vector3(0.31e18, -1e18, 0.47e18);

    private static final float FARTHEST = 1e9f;

    private final Vector3 origin;
    private float[] places = {};
    private float[] instances = {};
    private BodyOrder numbers = BodyOrder.EMPTY;
    private int present;
    private int[] lights = {};
    private Map<Integer, Light> suns = Map.of();
    private float[] floats = {};
    private boolean floatsHold;
    private boolean hierarchyHolds;
    private SphereHierarchy.Identity hierarchy = new SphereHierarchy.Identity();

    /** @param origin of the places, in the scene's coordinates */
    public PlaceTable(Vector3 origin) {
        this.origin = origin;
    }

    /**
     * Places all bodies.
     *
     * @param integrator decides which lights are drawn
     * @param spheres including those to be poured
     * @param newPresent number of present bodies without meshes
     * @param meshData {@link SceneMeshes#floats}
     */
    public void put(
            Lights newLights,
            Integrator integrator,
            Ground ground,
            List<Sphere> spheres,
            int newPresent,
            List<MeshBody> meshes,
            float[] meshData) {
        float[] before = places;
        float[] instancesBefore = instances;
        boolean held = floatsHold;
        BodyOrder numbersBefore = numbers;
        numbers = BodyOrder.of(spheres.size(), newLights);
        boolean samePresent = present == newPresent && numbers.equals(numbersBefore);
        present = newPresent;
        instances = InstanceTable.of(meshes, meshData, numbers.firstMesh());
        places = new float[Layout.PLACE_STRIDE * (numbers.firstMesh() + meshes.size())];
        put(newLights, integrator);
        put(ground);
        int body = Layout.FIRST_SPHERE;
        for (Sphere sphere : spheres) {
            place(body++, sphere.position().minus(origin), sphere.radius());
        }
        body = numbers.firstMesh();
        for (MeshBody mesh : meshes) {
            MeshBox box = MeshBox.of(mesh, meshData);
            place(body++, box.center(), box.radius());
        }
        int first = Layout.PLACE_STRIDE * Layout.FIRST_SPHERE;
        int last = Layout.PLACE_STRIDE * numbers.room();
        hierarchyHolds &= samePresent
                && before.length == places.length
                && Arrays.equals(before, first, last, places, first, last);
        floatsHold =
                held && hierarchyHolds && Arrays.equals(before, places) && Arrays.equals(instancesBefore, instances);
    }

    /** Places as many lights as there are. With path tracing, those that give no light are nowhere. */
    public void put(Lights newLights, Integrator integrator) {
        int[] drawn = new int[newLights.count()];
        int count = 0;
        Map<Integer, Light> newSuns = new HashMap<>();
        if (numbers.beginsWithSun()) {
            place(Layout.LIGHT, NOWHERE, 0);
        }
        for (int index = 0; index < newLights.count(); index++) {
            Light light = newLights.get(index);
            int body = numbers.light(index);
            boolean dark = integrator == Integrator.PATH && light.strength().orElse(1.0) == 0;
            if (light.isSun()) {
                newSuns.put(body, light);
            } else {
                place(body, dark ? NOWHERE : light.position().minus(origin), dark ? 0 : light.radius());
                if (body != Layout.LIGHT && !dark) {
                    drawn[count++] = body;
                }
            }
        }
        floatsHold &= newSuns.equals(suns);
        suns = newSuns;
        drawn = Arrays.copyOf(drawn, count);
        hierarchyHolds &= Arrays.equals(drawn, lights);
        lights = drawn;
    }

    public void put(Ground ground) {
        place(Layout.PLANE, new Vector3(0, ground.height(), 0).minus(origin), ground.size());
    }

    /** Puts the suns farther away than the bodies are from one another. */
    private void placeSuns() {
        float reach = 1;
        for (int body = 0; body < end(); body++) {
            int at = Layout.PLACE_STRIDE * body;
            float side = Math.max(Math.max(Math.abs(places[at]), Math.abs(places[at + 1])), Math.abs(places[at + 2]));
            // What is nowhere is beyond all that a scene may have.
            reach = suns.containsKey(body) || side > FARTHEST
                    ? reach
                    : Math.max(reach, side + places[at + Layout.PLACE_SIZE]);
        }
        // A power of two, so that a sun seldom moves when bodies do.
        double distance = 8 * Math.scalb(1.0, Math.getExponent(reach));
        suns.forEach((body, sun) ->
                place(body, sun.shape().toward().times(distance), sun.shape().discSine() * distance));
    }

    private void place(int body, Vector3 seen, double size) {
        float[] place = {(float) seen.x(), (float) seen.y(), (float) seen.z(), (float) size};
        int at = Layout.PLACE_STRIDE * body;
        floatsHold &= Arrays.equals(places, at, at + place.length, place, 0, place.length);
        System.arraycopy(place, 0, places, at, place.length);
    }

    /**
     * Moves the bodies, except meshes, suns and lights after the first.
     *
     * @param positions three floats for each of the first light, the plane and the spheres
     */
    public void move(float[] positions, int newPresent) {
        if (positions.length != 3 * numbers.room()) {
            throw new IllegalArgumentException(positions.length + " coordinates for " + numbers.room() + " bodies");
        }
        if (newPresent < Layout.FIRST_SPHERE || newPresent > numbers.room()) {
            throw new IllegalArgumentException(newPresent + " bodies of " + numbers.room());
        }
        for (int body = numbers.beginsWithSun() ? Layout.PLANE : Layout.LIGHT; body < numbers.room(); body++) {
            System.arraycopy(positions, 3 * body, places, Layout.PLACE_STRIDE * body, 3);
        }
        present = newPresent;
        floatsHold = false;
        hierarchyHolds = false;
    }

    /** The array; the same one as long as nothing has changed. */
    public float[] floats() {
        if (!floatsHold) {
            if (!suns.isEmpty()) {
                placeSuns();
            }
            if (hierarchyHolds) {
                floats = SphereHierarchy.kept(
                        floats, places, present, lights, numbers.room(), numbers.firstMesh(), instances);
            } else {
                floats = SphereHierarchy.of(places, present, lights, numbers.firstMesh(), instances);
                hierarchy = new SphereHierarchy.Identity();
            }
            floatsHold = true;
            hierarchyHolds = true;
        }
        return floats;
    }

    /** Of the last {@link #floats}. */
    public SphereHierarchy.Identity hierarchy() {
        return hierarchy;
    }

    public BodyOrder numbers() {
        return numbers;
    }

    /** Number of present bodies: the first light, the plane and the spheres. */
    public int present() {
        return present;
    }

    /** Place of the root over all spheres. */
    public int root() {
        return SphereHierarchy.root(end(), present, lights.length);
    }

    /** Place of the root over the spheres that cast shadows. */
    public int shadowRoot() {
        return SphereHierarchy.shadowRoot(root(), lights.length);
    }

    /** One more than the highest body number. */
    public int end() {
        return places.length / Layout.PLACE_STRIDE;
    }

    /** The first mesh's body, or {@link Layout#NO_MESHES} if no mesh is visible. */
    public int firstMesh() {
        return instances.length > 0 ? numbers.firstMesh() : Layout.NO_MESHES;
    }
}
