package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.Lights;
import dev.twister.world.SceneMeshes;
import dev.twister.world.hierarchy.HierarchyIdentity;
import dev.twister.world.hierarchy.SphereHierarchy;
import java.util.Arrays;
import java.util.List;

/**
 * The array {@code bodies} of {@link Layout}. The hierarchy over the spheres is built again only if spheres have
 * changed, moved or been poured.
 */
public final class PlaceTable {
    private final Vector3 origin;
    private float[] places = {};
    private float[] instances = {};
    private int room;
    private int firstMesh;
    private int present;
    private float[] floats = {};
    private boolean floatsHold;
    private boolean hierarchyHolds;
    private HierarchyIdentity hierarchy = new HierarchyIdentity();

    /** @param origin of the places, in the scene's coordinates */
    public PlaceTable(Vector3 origin) {
        this.origin = origin;
    }

    /**
     * Places all bodies.
     *
     * @param spheres including those to be poured
     * @param newPresent number of present bodies without meshes
     * @param meshData {@link SceneMeshes#floats}
     */
    public void put(
            Lights lights,
            Ground ground,
            List<Sphere> spheres,
            int newPresent,
            List<MeshBody> meshes,
            float[] meshData) {
        float[] before = places;
        float[] instancesBefore = instances;
        boolean held = floatsHold;
        boolean samePresent = present == newPresent && room == Layout.FIRST_SPHERE + spheres.size();
        room = Layout.FIRST_SPHERE + spheres.size();
        firstMesh = room + lights.further().size();
        present = newPresent;
        instances = InstanceTable.of(meshes, meshData, firstMesh);
        places = new float[Layout.PLACE_STRIDE * (firstMesh + meshes.size())];
        put(lights);
        put(ground);
        int body = Layout.FIRST_SPHERE;
        for (Sphere sphere : spheres) {
            place(body++, sphere.position().minus(origin), sphere.radius());
        }
        body = firstMesh;
        for (MeshBody mesh : meshes) {
            MeshBox box = MeshBox.of(mesh, meshData);
            place(body++, box.center(), box.radius());
        }
        int first = Layout.PLACE_STRIDE * Layout.FIRST_SPHERE;
        int last = Layout.PLACE_STRIDE * room;
        hierarchyHolds &= samePresent
                && before.length == places.length
                && Arrays.equals(before, first, last, places, first, last);
        floatsHold =
                held && hierarchyHolds && Arrays.equals(before, places) && Arrays.equals(instancesBefore, instances);
    }

    /** Places as many lights as there are. */
    public void put(Lights lights) {
        put(Layout.LIGHT, lights.first());
        int body = room;
        for (Light light : lights.further()) {
            put(body++, light);
        }
    }

    private void put(int body, Light light) {
        place(body, light.position().minus(origin), light.radius());
    }

    public void put(Ground ground) {
        place(Layout.PLANE, new Vector3(0, ground.height(), 0).minus(origin), ground.size());
    }

    private void place(int body, Vector3 seen, double size) {
        float[] place = {(float) seen.x(), (float) seen.y(), (float) seen.z(), (float) size};
        int at = Layout.PLACE_STRIDE * body;
        floatsHold &= Arrays.equals(places, at, at + place.length, place, 0, place.length);
        System.arraycopy(place, 0, places, at, place.length);
    }

    /**
     * Moves the bodies, except meshes and further lights.
     *
     * @param positions three floats for each of the first light, the plane and the spheres
     */
    public void move(float[] positions, int newPresent) {
        if (positions.length != 3 * room) {
            throw new IllegalArgumentException(positions.length + " coordinates for " + room + " bodies");
        }
        if (newPresent < Layout.FIRST_SPHERE || newPresent > room) {
            throw new IllegalArgumentException(newPresent + " bodies of " + room);
        }
        for (int body = 0; body < room; body++) {
            System.arraycopy(positions, 3 * body, places, Layout.PLACE_STRIDE * body, 3);
        }
        present = newPresent;
        floatsHold = false;
        hierarchyHolds = false;
    }

    /** The array; the same one as long as nothing has changed. */
    public float[] floats() {
        if (!floatsHold) {
            if (hierarchyHolds) {
                floats = SphereHierarchy.kept(floats, places, room, instances);
            } else {
                floats = SphereHierarchy.of(places, present, room, instances);
                hierarchy = new HierarchyIdentity();
            }
            floatsHold = true;
            hierarchyHolds = true;
        }
        return floats;
    }

    /** Of the last {@link #floats}. */
    public HierarchyIdentity hierarchy() {
        return hierarchy;
    }

    /** Maximum number of bodies without meshes and further lights; the second light is numbered from here. */
    public int room() {
        return room;
    }

    /** Number of present bodies without meshes and further lights. */
    public int present() {
        return present;
    }

    /** One more than the highest body number. */
    public int end() {
        return places.length / Layout.PLACE_STRIDE;
    }

    /** The first mesh's body, or {@link Layout#NO_MESHES} if no mesh is visible. */
    public int firstMesh() {
        return instances.length > 0 ? firstMesh : Layout.NO_MESHES;
    }
}
