package dev.twister.oracle;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Geometry;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rotation;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import dev.twister.world.SceneMeshes;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * {@link RandomMaterials} with meshes: flat and smooth solids and triangle soups of all materials, rotated, scaled,
 * mirrored, instanced, around the camera, in the ground and in spheres.
 */
public final class RandomMeshes {
    private static final int LEVELS = 2;
    private static final int MOST_MESHES = 4;

    private RandomMeshes() {}

    /** Any scene, from one source of randomness. */
    public static LitScene scene(Random random, int bounces) {
        LitScene plain = RandomMaterials.scene(random, bounces);
        Map<Geometry, MeshFile> files = new HashMap<>();
        List<Mesh> meshes = new ArrayList<>();
        int triangles = 0;
        int count = 1 + random.nextInt(MOST_MESHES);
        for (int i = 0; i < count; i++) {
            Geometry file = new Geometry.OfFile(Path.of("mesh" + random.nextInt(count)));
            files.computeIfAbsent(file, name -> file(random));
            triangles += (int) files.get(file).shownTriangles();
            meshes.add(mesh(random, file));
        }
        Scene scene = plain.scene().withMeshes(meshes);
        return new LitScene(
                scene.withRendering(RandomMaterials.settings(
                        scene.rendering(), scene.spheres().size() + triangles)),
                plain.images(),
                SceneMeshes.of(scene, source -> files.get(source.geometry())));
    }

    private static Mesh mesh(Random random, Geometry file) {
        Vector3 position = new Vector3(
                RandomScenes.between(random, -5, 5),
                RandomScenes.between(random, -1, 4),
                RandomScenes.between(random, -5, 5));
        double pitch = RandomScenes.extremeOr(random, 0, 90, RandomScenes.between(random, -90, 90));
        double yaw = RandomScenes.extremeOr(random, 0, 90, RandomScenes.between(random, -180, 180));
        double roll = RandomScenes.extremeOr(random, 0, 45, RandomScenes.between(random, -180, 180));
        Mesh mesh = Mesh.of(file)
                .withPosition(position)
                .withRotation(new Rotation(yaw, pitch, roll))
                .withScale(RandomScenes.between(random, 0.3, 3));
        return random.nextBoolean() ? mesh : mesh.withMaterial(material(random));
    }

    private static Material material(Random random) {
        return RandomMaterials.material(
                random,
                Material.DEFAULT
                        .withColor(RandomScenes.albedo(random))
                        .withReflectivity(RandomScenes.reflectivity(random)));
    }

    private static MeshFile file(Random random) {
        List<MeshPart> parts = new ArrayList<>();
        parts.add(new MeshPart("first", 0, Affine.IDENTITY, material(random)));
        if (random.nextInt(3) == 0) {
            Affine placement = new Affine(
                    new Vector3(0, RandomScenes.between(random, 0.5, 2), 0.3),
                    new Vector3(RandomScenes.between(random, 0.5, 2), 0, 0),
                    new Vector3(0.2, 0, random.nextBoolean() ? 1 : -1),
                    new Vector3(0.5, 1.5, RandomScenes.between(random, -2, 2)));
            parts.add(new MeshPart("second", random.nextInt(2), placement, material(random)));
        }
        return MeshShapes.file(List.of(shape(random), shape(random)), parts);
    }

    private static TriangleMesh shape(Random random) {
        TriangleMesh sphere = MeshShapes.icosphere(random.nextInt(LEVELS));
        return switch (random.nextInt(6)) {
            case 0 -> sphere;
            case 1 -> new TriangleMesh(sphere.positions(), new float[0], sphere.textureCoordinates(), sphere.corners());
            case 2 -> MeshShapes.cube();
            case 3 -> MeshShapes.square();
            case 4 -> MeshShapes.soup(random, 1 + random.nextInt(20));
            default -> MeshShapes.blob(random, random.nextInt(LEVELS));
        };
    }
}
