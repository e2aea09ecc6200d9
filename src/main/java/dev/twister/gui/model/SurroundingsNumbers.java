package dev.twister.gui.model;

import dev.twister.gui.model.NumberSetting.Scale;
import dev.twister.scene.Range;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Shading;

/** The numbers of what is around the spheres: the plane, ambient light, and how bodies meet. */
public final class SurroundingsNumbers {
    private SurroundingsNumbers() {}

    public static final NumberSetting AMBIENT = new NumberSetting(
            "Ambient light",
            "Brightness of surfaces in shadow, as a share of their color.",
            SceneLimits.AMBIENT,
            new Range(0, 1),
            Scale.LINEAR,
            2,
            "",
            scene -> scene.shading().ambient(),
            (scene, ambient) -> scene.withShading(new Shading(ambient)));

    public static final NumberSetting PLANE_SIZE = new NumberSetting(
            "Plane size",
            "The side of the square. Walls stand on its border.",
            SceneLimits.LENGTH,
            new Range(1, 1000),
            Scale.LOGARITHMIC,
            1,
            "m",
            scene -> scene.ground().size(),
            (scene, size) -> scene.withGround(scene.ground().withSize(size)));

    public static final NumberSetting PLANE_HEIGHT = SceneNumbers.place(
            "Plane height",
            "The plane's y. The camera stays above it.",
            scene -> scene.ground().height(),
            (scene, height) -> scene.withGround(scene.ground().withHeight(height)));

    public static final NumberSetting ELASTICITY = new NumberSetting(
            "Elasticity",
            "Share of the speed that bodies keep when they bounce.",
            SceneLimits.ELASTICITY,
            new Range(0, 1),
            Scale.LINEAR,
            2,
            "",
            scene -> scene.physics().elasticity(),
            (scene, share) -> scene.withPhysics(scene.physics().withElasticity(share)));

    public static final NumberSetting FRICTION = new NumberSetting(
            "Friction",
            "Coulomb's coefficient between bodies, and between bodies and plane or walls.",
            SceneLimits.FRICTION,
            new Range(0, 1),
            Scale.LINEAR,
            2,
            "",
            scene -> scene.physics().friction(),
            (scene, coefficient) -> scene.withPhysics(scene.physics().withFriction(coefficient)));
}
