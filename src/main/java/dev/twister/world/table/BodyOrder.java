package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;

/**
 * The numbers of a scene's bodies: the first light, the plane, the spheres, the other lights, the parts of meshes.
 *
 * @param spheres number of spheres, including those to be poured
 * @param lights number of lights, at least 1
 */
public record BodyOrder(int spheres, int lights) {
    public static BodyOrder of(Scene scene) {
        return new BodyOrder(scene.allSpheres().size(), scene.lights().count());
    }

    public int light(int index) {
        return index == 0 ? Layout.LIGHT : room() + index - 1;
    }

    public int sphere(int index) {
        return Layout.FIRST_SPHERE + index;
    }

    /** One more than the highest number of a sphere that is no light. */
    public int room() {
        return Layout.FIRST_SPHERE + spheres;
    }

    public int firstMesh() {
        return room() + lights - 1;
    }
}
