package dev.twister.gui.model;

import dev.twister.scene.Material;
import dev.twister.scene.Scene;
import java.util.function.UnaryOperator;

/** What a scene's spheres and its plane are made of, by their {@link BodyNumber}. */
public final class BodyMaterials {
    private BodyMaterials() {}

    /** Whether it is a body with a material: the plane or a sphere. */
    public static boolean has(Scene scene, int body) {
        return body == BodyNumber.PLANE || BodyEdits.isSphere(scene, body);
    }

    public static Material of(Scene scene, int body) {
        return body == BodyNumber.PLANE
                ? scene.plane().material()
                : BodyEdits.sphere(scene, body).material();
    }

    /** The scene with another material of that body alone. */
    public static Scene edited(Scene scene, int body, UnaryOperator<Material> edit) {
        Material material = edit.apply(of(scene, body));
        return body == BodyNumber.PLANE
                ? scene.withPlane(scene.plane().withMaterial(material))
                : BodyEdits.edited(scene, body, sphere -> sphere.withMaterial(material));
    }
}
