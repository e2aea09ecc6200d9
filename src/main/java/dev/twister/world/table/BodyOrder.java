package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.light.Lights;

/**
 * The numbers of a scene's bodies: the first light, the plane, the spheres, the other lights, the parts of meshes. A
 * sun is never the first body, which rays can hit.
 *
 * @param spheres number of spheres, including those to be poured
 * @param lights number of lights, at least 1
 * @param beginsWithSun whether the first light is a sun, which comes after the spheres, too
 */
public record BodyOrder(int spheres, int lights, boolean beginsWithSun) {
    static final BodyOrder EMPTY = new BodyOrder(0, 1, false);

    public static BodyOrder of(Scene scene) {
        return of(scene.allSpheres().size(), scene.lights());
    }

    static BodyOrder of(int spheres, Lights lights) {
        return new BodyOrder(spheres, lights.count(), lights.first().isSun());
    }

    public int light(int index) {
        return index == 0 && !beginsWithSun ? Layout.LIGHT : room() + index - (beginsWithSun ? 0 : 1);
    }

    public int sphere(int index) {
        return Layout.FIRST_SPHERE + index;
    }

    /** One more than the highest number of a sphere that is no light. */
    public int room() {
        return Layout.FIRST_SPHERE + spheres;
    }

    public int firstMesh() {
        return room() + lights - (beginsWithSun ? 0 : 1);
    }
}
