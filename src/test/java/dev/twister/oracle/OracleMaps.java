package dev.twister.oracle;

import dev.twister.scene.Material;
import dev.twister.scene.material.Alpha;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.sky.FloatImages;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

/** The maps of a mesh's material besides its texture. Normal maps here have colors, no heights. */
record OracleMaps(
        Optional<OracleTexture> emission,
        Optional<OracleTexture> roughness,
        Optional<OracleTexture> metallic,
        Optional<OracleTexture> normal,
        double normalScale,
        Optional<OracleTexture> occlusion,
        double occlusionStrength,
        Optional<OracleTexture> opacity,
        Alpha alpha,
        boolean unlit) {
    static final OracleMaps NONE = new OracleMaps(
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            1,
            Optional.empty(),
            1,
            Optional.empty(),
            Alpha.OPAQUE,
            false);

    static OracleMaps of(Material material, SceneImages images) {
        Maps maps = material.maps();
        return new OracleMaps(
                maps.emission().map(map -> new OracleTexture(image(map.file(), images), map.sampler())),
                numbers(maps.roughness(), images),
                numbers(maps.metallic(), images),
                numbers(maps.normal(), images),
                maps.normal().map(ImageMap::scale).orElse(1.0),
                numbers(maps.occlusion(), images),
                maps.occlusion().map(ImageMap::scale).orElse(1.0),
                numbers(maps.alpha(), images)
                        .or(() -> material.texture()
                                .map(file -> opacity(image(file, images)))
                                .map(picture -> new OracleTexture(picture, maps.texture()))),
                material.alpha(),
                material.unlit());
    }

    private static Skybox image(Path file, SceneImages images) {
        return FloatImages.of(images.textureByFile().get(file));
    }

    private static Optional<OracleTexture> numbers(Optional<ImageMap> map, SceneImages images) {
        return map.map(found -> new OracleTexture(stored(image(found.file(), images)), found.sampler()));
    }

    /** The numbers from which the linear ones were decoded. */
    private static Skybox stored(Skybox linear) {
        DoubleUnaryOperator encode = x -> x < 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055;
        float[] stored = new float[linear.radiance().length];
        for (int i = 0; i < stored.length; i++) {
            stored[i] = (float) encode.applyAsDouble(linear.radiance()[i]);
        }
        return new Skybox(linear.width(), linear.height(), stored);
    }

    private static Skybox opacity(Skybox image) {
        float[] gray = new float[image.radiance().length];
        for (int i = 0; i < gray.length; i++) {
            gray[i] = image.opacity().length == 0 ? 1 : image.opacity()[i / 3];
        }
        return new Skybox(image.width(), image.height(), gray);
    }

    /** @param vertex opacity of the vertices there */
    double opacity(double u, double v, double vertex) {
        return alpha.factor()
                * vertex
                * opacity.map(map -> map.color(u, v).red()).orElse(1.0);
    }

    boolean cuts() {
        return alpha.mode() == Alpha.Mode.MASK;
    }

    boolean blends() {
        return alpha.mode() == Alpha.Mode.BLEND;
    }

    /** What multiplies the ambient light. */
    double open(double u, double v) {
        return 1
                + occlusionStrength
                        * (occlusion.map(map -> map.color(u, v).red()).orElse(1.0) - 1);
    }

    /** A material where the maps have these coordinates. */
    OracleMaterial at(OracleMaterial material, double u, double v, double vertexOpacity) {
        double rough = material.roughness()
                * roughness.map(map -> map.color(u, v).green()).orElse(1.0);
        double metal = material.metallic()
                * metallic.map(map -> map.color(u, v).blue()).orElse(1.0);
        boolean derived = material.byFresnel() && (metal > 0 || material.transmission() == 0);
        double beside = material.besideMetal()
                ? Math.max(material.besideReflectivity(), 96 * metal * (1 - rough))
                : material.reflectivity();
        double reflectivity = derived ? (5 + 91 * metal) * (1 - rough) : beside;
        Color emitted =
                material.emission().times(emission.map(map -> map.color(u, v)).orElse(new Color(1, 1, 1)));
        double opacity = blends() ? opacity(u, v, vertexOpacity) : 1;
        return new OracleMaterial(
                material.color(),
                unlit ? 0 : opacity * reflectivity,
                blends() ? 0 : rough,
                blends() ? 1 - opacity : material.transmission(),
                blends() ? 1 : material.ior(),
                !blends() && material.thin(),
                material.texture(),
                unlit ? 0 : metal,
                material.byFresnel(),
                material.besideMetal(),
                material.besideReflectivity(),
                emitted.times(opacity),
                material.emitsInward(),
                material.absorption());
    }

    /** Turns a normal as the map says. */
    Vector turned(Vector normal, Vector toRight, Vector upward, double u, double v) {
        if (normal().isEmpty()) {
            return normal;
        }
        Color texel = normal().get().color(u, v);
        Vector right = toRight.minus(normal.times(toRight.dot(normal))).normalized();
        Vector up = normal.cross(right);
        up = up.dot(upward) < 0 ? up.times(-1) : up;
        Vector turned = right.times(normalScale * (2 * texel.red() - 1))
                .plus(up.times(normalScale * (2 * texel.green() - 1)))
                .plus(normal.times(2 * texel.blue() - 1))
                .normalized();
        return turned;
    }

    /** A normal that looks toward the viewer, if only just. */
    static Vector facing(Vector normal, Vector toViewer) {
        double lacking = 0.01 - normal.dot(toViewer);
        return lacking > 0 ? normal.plus(toViewer.times(lacking)).normalized() : normal;
    }
}
