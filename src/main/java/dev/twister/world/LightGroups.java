package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.kernel.LightLayers;
import dev.twister.scene.Integrator;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Sphere;
import dev.twister.scene.light.LightGroup;
import dev.twister.scene.material.Emission;
import dev.twister.world.table.BodyOrder;
import dev.twister.world.table.MeshBody;
import java.util.ArrayList;
import java.util.List;

/**
 * The groups of a scene's lights, each of which can be a layer of the picture.
 *
 * @param names of the groups, in the order of the layers
 * @param layers of the sky and of each body, as {@link LightLayers} reads them
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record LightGroups(List<String> names, float[] layers) {
    /**
     * The groups of a scene.
     *
     * @throws SceneException if a light or an emitting body names the group of other light, such as the sky's
     * @throws IllegalArgumentException if there are more than {@link Layout#MOST_LIGHT_LAYERS}
     */
    public static LightGroups of(Scene scene, List<MeshBody> meshes) {
        List<Sphere> spheres = scene.allSpheres();
        BodyOrder bodies = BodyOrder.of(scene);
        Numbers numbers = new Numbers(1 + bodies.firstMesh() + meshes.size());
        if (scene.sky().strength() > 0) {
            numbers.put(Layout.NOTHING, LightGroup.SKY);
        }
        if (scene.rendering().integrator() == Integrator.WHITTED) {
            numbers.put(Layout.PLANE, LightGroup.AMBIENT);
        }
        for (int index = 0; index < scene.lights().count(); index++) {
            numbers.put(bodies.light(index), group(scene.lights().get(index)));
        }
        for (int index = 0; index < spheres.size(); index++) {
            putEmitter(numbers, bodies.sphere(index), spheres.get(index).material());
        }
        for (int index = 0; index < meshes.size(); index++) {
            putEmitter(numbers, bodies.firstMesh() + index, meshes.get(index).material());
        }
        return numbers.groups();
    }

    private static String group(Light light) {
        return named(light.group(), LightGroup.LIGHTS);
    }

    private static void putEmitter(Numbers numbers, int body, Material material) {
        Emission emission = material.emission();
        if (!emission.isNone() || material.unlit()) {
            numbers.put(body, named(emission.group(), LightGroup.EMITTERS));
        }
    }

    private static String named(String group, String usual) {
        if (!group.equals(usual) && LightGroup.RESERVED.containsKey(group)) {
            throw new SceneException("lightGroup is '" + group + "', which is the light layer of "
                    + LightGroup.RESERVED.get(group) + "; give the group another name");
        }
        return group.equals(LightGroup.NONE) ? usual : group;
    }

    /** Numbers groups of lights in the order in which they are first named. */
    private static final class Numbers {
        private final List<String> names = new ArrayList<>();
        private final float[] layers;

        /** @param length number of bodies, and one for the sky */
        Numbers(int length) {
            layers = new float[length];
        }

        /** Puts a body, or the sky as {@link Layout#NOTHING}, in a group. */
        void put(int body, String name) {
            if (!names.contains(name)) {
                names.add(name);
            }
            layers[1 + body] = names.indexOf(name);
        }

        LightGroups groups() {
            if (names.size() > Layout.MOST_LIGHT_LAYERS) {
                throw new IllegalArgumentException(
                        names.size() + " groups of lights; there are at most " + Layout.MOST_LIGHT_LAYERS);
            }
            return new LightGroups(List.copyOf(names), layers);
        }
    }
}
