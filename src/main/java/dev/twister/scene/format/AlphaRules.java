package dev.twister.scene.format;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.material.Alpha;
import java.util.Optional;
import java.util.function.Function;

/** Which bodies may be other than opaque: meshes alone. */
final class AlphaRules {
    private AlphaRules() {}

    /**
     * @param fields the scene's, in the file
     * @throws SceneException if the plane or a sphere is not opaque
     */
    static void check(Scene scene, Fields fields) {
        fields.find("plane").ifPresent(plane -> check(scene.ground().material(), plane));
        fields.find("pour").ifPresent(place -> scene.pour().ifPresent(pour -> check(pour.material(), place)));
        fields.find("spheres").ifPresent(spheres -> {
            for (int i = 0; i < scene.spheres().size(); i++) {
                Material material = scene.spheres().get(i).material();
                if (!isOpaque(material)) {
                    check(
                            material,
                            spheres.items(0, scene.spheres().size(), "", Function.identity())
                                    .get(i));
                }
            }
        });
    }

    private static void check(Material material, Place body) {
        if (!isOpaque(material)) {
            Optional<Place> own = body.fields().find("alphaMode");
            throw own.isPresent()
                    ? own.get().failure("is given, but only meshes can be cut out or blended; take a shape")
                    : body.fields()
                            .get("material")
                            .failure("is a material that is not opaque, but only meshes can be; take a shape");
        }
    }

    private static boolean isOpaque(Material material) {
        return material.alpha().mode() == Alpha.Mode.OPAQUE;
    }
}
