package dev.twister.world.table;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Variant;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.light.Lights;
import dev.twister.scene.material.Emission;
import dev.twister.world.SceneImages;
import java.util.Arrays;
import java.util.List;

/**
 * The arrays {@code looks} and {@code images} of {@link Layout}; the same ones as long as their content is the same.
 */
public final class LookTable {
    /** Lower bound of a color whose logarithm is taken. */
    private static final double DARKEST = 1e-9;

    /** Least difference of the cosines between which a spot fades out, as glTF has it. */
    private static final double LEAST_BLEND = 0.001;

    private float[] looks = {};
    private int materials;
    private BodyOrder numbers = BodyOrder.EMPTY;
    private int lightTable;
    private MapTexels texels = MapTexels.NONE;
    private final AlbedoTables albedos = new AlbedoTables();

    /**
     * The looks of all bodies.
     *
     * @param spheres including those to be poured
     * @param meshFloats the array {@code meshes} of {@link Layout}, without maps
     * @throws IllegalArgumentException if one of the textures is missing
     */
    public void put(
            Lights lights,
            Ground ground,
            List<Sphere> spheres,
            List<MeshBody> meshes,
            float[] meshFloats,
            SceneImages newImages) {
        MapTable table = new MapTable(newImages);
        FinishTable finishes = new FinishTable(table);
        numbers = BodyOrder.of(spheres.size(), lights);
        float[] materials = new float[Layout.LOOK_STRIDE * (numbers.firstMesh() + meshes.size())];
        put(materials, Layout.PLANE, ground.material(), table.row(ground.material()), finishes);
        int body = Layout.FIRST_SPHERE;
        for (Sphere sphere : spheres) {
            put(materials, body++, sphere.material(), table.row(sphere.material()), finishes);
        }
        body = numbers.firstMesh();
        for (MeshBody mesh : meshes) {
            put(materials, body++, mesh.material(), table.row(mesh), finishes);
        }
        this.materials = arePlain(materials) ? 0 : Variant.MATERIALS | table.variant() | finishes.variant();
        put(materials, lights);
        texels = texels.changedTo(newImages, table.uses(), table.opacities(), meshFloats);
        float[] mapped = table.withTable(materials, texels);
        lightTable = mapped.length;
        float[] all = Arrays.copyOf(mapped, lightTable + lights.count());
        for (int index = 0; index < lights.count(); index++) {
            all[lightTable + index] = numbers.light(index);
        }
        int bodies = numbers.firstMesh() + meshes.size();
        replace(albedos.appendTo(finishes.appendTo(all, bodies, texels), bodies));
    }

    /** Changes as many lights as there are; a light that only moves leaves the array as it is. */
    public void put(Lights lights) {
        if (!has(lights)) {
            float[] changed = looks.clone();
            put(changed, lights);
            looks = changed;
        }
    }

    private boolean has(Lights lights) {
        boolean same = true;
        for (int index = 0; index < lights.count() && same; index++) {
            int look = Layout.LOOK_STRIDE * numbers.light(index);
            float[] row = Arrays.copyOfRange(looks, look, look + Layout.LOOK_STRIDE);
            put(row, 0, lights.get(index));
            same = Arrays.equals(row, 0, row.length, looks, look, look + Layout.LOOK_STRIDE);
        }
        return same;
    }

    private void put(float[] materials, Lights lights) {
        for (int index = 0; index < lights.count(); index++) {
            put(materials, Layout.LOOK_STRIDE * numbers.light(index), lights.get(index));
        }
    }

    private static void put(float[] materials, int look, Light light) {
        putColor(materials, look, light.color());
        materials[look + Layout.LOOK_SHARE] = (float) light.share();
        LightShape shape = light.shape();
        materials[look + Layout.LOOK_LIGHT] = switch (shape.kind()) {
            case SPHERE -> Layout.SPHERE_LIGHT;
            case SUN -> Layout.SUN_LIGHT;
            case SPOT -> Layout.SPOT_LIGHT;
        };
        putSpot(materials, look, shape);
    }

    private static void putSpot(float[] looks, int look, LightShape shape) {
        Vector3 axis = shape.toward().times(-1);
        looks[look + Layout.LOOK_SPOT_AXIS] = (float) axis.x();
        looks[look + Layout.LOOK_SPOT_AXIS + 1] = (float) axis.y();
        looks[look + Layout.LOOK_SPOT_AXIS + 2] = (float) axis.z();
        double scale = 1 / Math.max(LEAST_BLEND, shape.innerCosine() - shape.outerCosine());
        looks[look + Layout.LOOK_SPOT_SCALE] = (float) scale;
        looks[look + Layout.LOOK_SPOT_OFFSET] = (float) (-shape.outerCosine() * scale);
        looks[look + Layout.LOOK_SUN_SINE] = (float) shape.discSine();
    }

    private void replace(float[] changed) {
        if (!Arrays.equals(changed, looks)) {
            looks = changed;
        }
    }

    public float[] looks() {
        return looks;
    }

    /** Place in the looks of the table of lights. */
    public int lightTable() {
        return lightTable;
    }

    public float[] texels() {
        return texels.images().floats();
    }

    /** The meshes, with the opacity maps behind them. */
    public float[] meshes() {
        return texels.meshes().floats();
    }

    /** What the materials of all bodies, present or not, need of the kernel: bits of {@link Variant}. */
    public int materials() {
        return materials;
    }

    private static boolean arePlain(float[] looks) {
        for (int look = 0; look < looks.length; look++) {
            if (look % Layout.LOOK_STRIDE > Layout.LOOK_REFLECTIVITY && looks[look] != 0) {
                return false;
            }
        }
        return true;
    }

    private static void put(float[] looks, int body, Material material, int maps, FinishTable finishes) {
        int look = Layout.LOOK_STRIDE * body;
        putColor(looks, look, material.color());
        boolean fresnel = material.isByFresnel();
        float reflectivity = (float) material.whittedReflectivity();
        float transmission = (float) material.transmission();
        looks[look + Layout.LOOK_REFLECTIVITY] = reflectivity;
        looks[look + Layout.LOOK_TRANSMISSION] = transmission;
        // Properties without effect stay 0, so that the body counts as plain.
        boolean glossy = fresnel || reflectivity > 0 || transmission > 0;
        looks[look + Layout.LOOK_ROUGHNESS] = glossy ? (float) material.roughness() : 0;
        looks[look + Layout.LOOK_IOR] = fresnel || transmission > 0 ? (float) material.ior() : 0;
        boolean dielectric = material.reflectivity() == 0 && (fresnel || transmission > 0);
        looks[look + Layout.LOOK_SPECULAR_LOSS] = dielectric ? (float) (1 - material.specular()) : 0;
        looks[look + Layout.LOOK_METALLIC] = (float) material.metallic();
        boolean beside = material.isMetalOverMirror();
        looks[look + Layout.LOOK_FRESNEL] = fresnel ? 1 : beside ? -1 : 0;
        looks[look + Layout.LOOK_BESIDE_METAL] = beside ? (float) material.reflectivity() : 0;
        putEmission(looks, look, material.emission());
        looks[look + Layout.LOOK_FINISH] = finishes.number(material);
        boolean translucent =
                material.hasFinish() && material.finish().through().part() > 0;
        boolean sheet = transmission > 0 ? material.thinWalled() : translucent;
        looks[look + Layout.LOOK_SHEET] = sheet ? Layout.SHEET_OF_BODY : 0;
        material.attenuation().distance().ifPresent(distance -> putAbsorption(looks, look, material, distance));
        looks[look + Layout.LOOK_MAPS] = maps;
    }

    private static void putEmission(float[] looks, int look, Emission emission) {
        if (!emission.isNone()) {
            putColor(looks, look + Layout.LOOK_EMISSION, emission.radiance());
            looks[look + Layout.LOOK_ONE_SIDED] = emission.doubleSided() ? 0 : 1;
        }
    }

    /** Per meter, so that the attenuation's color is left after the distance. */
    private static void putAbsorption(float[] looks, int look, Material material, double distance) {
        Rgb color = material.attenuation().color();
        looks[look + Layout.LOOK_ABSORPTION] = absorption(color.red(), distance);
        looks[look + Layout.LOOK_ABSORPTION + 1] = absorption(color.green(), distance);
        looks[look + Layout.LOOK_ABSORPTION + 2] = absorption(color.blue(), distance);
    }

    private static float absorption(double color, double distance) {
        return (float) (Math.max(-Math.log(Math.max(color, DARKEST)), 0) / distance);
    }

    public static void putColor(float[] array, int at, Rgb color) {
        array[at] = (float) color.red();
        array[at + 1] = (float) color.green();
        array[at + 2] = (float) color.blue();
    }
}
