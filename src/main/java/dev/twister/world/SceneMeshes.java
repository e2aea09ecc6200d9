package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshPlacement;
import dev.twister.mesh.MeshReader;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The meshes that a scene names, each file once, with a hierarchy over the triangles of each mesh in it. A world of the
 * same scene with its meshes elsewhere has the same ones.
 */
public final class SceneMeshes {
    /** Of a scene without meshes. */
    public static final SceneMeshes NONE = new SceneMeshes(new float[1], Map.of());

    private final float[] floats;
    private final Map<Source, Loaded> loadedBySource;

    /** What is read: normals that a file leaves out depend on the angle. */
    public record Source(Path file, double smoothDegrees) {
        public static Source of(Mesh mesh) {
            return new Source(mesh.file(), mesh.smoothDegrees());
        }
    }

    /**
     * A file and where its meshes are.
     *
     * @param places one for each of the file's meshes
     * @param farPoints see {@link FarPoints}
     */
    private record Loaded(MeshFile file, List<MeshPlace> places, List<Vector3> farPoints) {}

    private SceneMeshes(float[] floats, Map<Source, Loaded> loadedBySource) {
        this.floats = floats;
        this.loadedBySource = loadedBySource;
    }

    /**
     * Reads a scene's meshes, each file once.
     *
     * @param warnings told of what the files say and is not used; one line each
     * @throws MeshException as {@link #of}
     */
    public static SceneMeshes read(Scene scene, Consumer<String> warnings) {
        return of(scene, reader(warnings));
    }

    /** Reads files by {@link MeshReader#read}. */
    public static Function<Source, MeshFile> reader(Consumer<String> warnings) {
        return source -> MeshReader.read(source.file(), source.smoothDegrees(), warnings);
    }

    /**
     * A scene's meshes.
     *
     * @param reader reads a file, as {@link MeshReader#read} does
     * @throws MeshException where the reader does; the message says where the scene file names the file; and where all
     *     together are more than an array holds
     */
    public static SceneMeshes of(Scene scene, Function<Source, MeshFile> reader) {
        return NONE.changedTo(scene.meshes(), reader);
    }

    /**
     * These meshes, of another scene, say; those that are here already are not read again.
     *
     * @throws MeshException as {@link #of} does
     */
    public SceneMeshes changedTo(List<Mesh> meshes, Function<Source, MeshFile> reader) {
        Map<Source, MeshFile> files = new LinkedHashMap<>();
        for (int i = 0; i < meshes.size(); i++) {
            Source source = Source.of(meshes.get(i));
            if (!files.containsKey(source)) {
                files.put(source, file(source, "meshes[" + i + "].file", reader));
            }
        }
        return files.keySet().equals(loadedBySource.keySet()) ? this : with(files);
    }

    private MeshFile file(Source source, String place, Function<Source, MeshFile> reader) {
        if (loadedBySource.containsKey(source)) {
            return loadedBySource.get(source).file();
        }
        try {
            return reader.apply(source);
        } catch (MeshException problem) {
            throw new MeshException(place + ": " + problem.getMessage(), problem);
        }
    }

    private SceneMeshes with(Map<Source, MeshFile> files) {
        List<float[]> parts = new ArrayList<>();
        Map<Source, Loaded> loaded = new LinkedHashMap<>();
        int start = 0;
        for (Map.Entry<Source, MeshFile> entry : files.entrySet()) {
            Loaded before = loadedBySource.get(entry.getKey());
            MeshFile file = entry.getValue();
            List<MeshPlace> places = new ArrayList<>();
            for (int mesh = 0; mesh < file.meshes().size(); mesh++) {
                MeshGeometry geometry = before == null
                        ? MeshGeometry.of(file.meshes().get(mesh))
                        : before.places().get(mesh).geometry(floats);
                places.add(MeshPlace.of(start, geometry));
                parts.add(geometry.floats());
                start = checked(start + (long) geometry.floats().length);
            }
            List<Vector3> farPoints = before == null ? FarPoints.of(file) : before.farPoints();
            loaded.put(entry.getKey(), new Loaded(file, places, farPoints));
        }
        return new SceneMeshes(joined(parts, start), loaded);
    }

    private static int checked(long length) {
        if (length > Integer.MAX_VALUE - Long.BYTES) {
            throw new MeshException("the meshes have too many triangles together: an array holds "
                    + Integer.MAX_VALUE / Layout.TRIANGLE_STRIDE + " at most");
        }
        return (int) length;
    }

    private static float[] joined(List<float[]> parts, int length) {
        if (parts.size() == 1) {
            return parts.getFirst();
        }
        float[] joined = new float[Math.max(1, length)];
        int at = 0;
        for (float[] part : parts) {
            System.arraycopy(part, 0, joined, at, part.length);
            at += part.length;
        }
        return joined;
    }

    /** All of them as {@link Layout} has them; the same array as long as they are the same. */
    float[] floats() {
        return floats;
    }

    /** The scene without the meshes that are not here. */
    public Scene shown(Scene scene) {
        return scene.meshes().stream().allMatch(this::holds)
                ? scene
                : scene.withMeshes(scene.meshes().stream().filter(this::holds).toList());
    }

    /** Whether the mesh's file is here. */
    public boolean holds(Mesh mesh) {
        return loadedBySource.containsKey(Source.of(mesh));
    }

    /** What a mesh's file holds. */
    public MeshFile file(Mesh mesh) {
        return loaded(mesh).file();
    }

    /**
     * Vertices of a mesh that is here, where the scene has it: those that lie farthest out in many directions, so that
     * its outline from anywhere is about that of these points.
     */
    public List<Vector3> farPoints(Mesh mesh) {
        Affine placement = MeshPlacement.of(mesh);
        return loaded(mesh).farPoints().stream().map(placement::point).toList();
    }

    /** How many bodies of a picture a mesh that is here comes to: one for each part. */
    public int parts(Mesh mesh) {
        return loaded(mesh).file().parts().size();
    }

    /** What a mesh that is here is made of where the scene does not say: the material of its file's first part. */
    public Material fileMaterial(Mesh mesh) {
        Material material = loaded(mesh).file().parts().getFirst().material();
        boolean embedded = material.texture().flatMap(this::embeddedImage).isPresent();
        // No scene file can name what is inside another file.
        return embedded ? material.withTexture(Optional.empty()) : material;
    }

    /**
     * The textures that the files' own materials have, where a mesh of the scene shows them, and where it names the
     * file.
     */
    Map<Path, String> textures(Scene scene) {
        Map<Path, String> placeByTexture = new LinkedHashMap<>();
        for (int i = 0; i < scene.meshes().size(); i++) {
            Mesh mesh = scene.meshes().get(i);
            if (mesh.material().isEmpty()) {
                for (MeshPart part : file(mesh).parts()) {
                    String place = "meshes[" + i + "].file";
                    part.material().texture().ifPresent(texture -> placeByTexture.putIfAbsent(texture, place));
                }
            }
        }
        return placeByTexture;
    }

    /** The PNG or JPEG file of a texture that is inside one of the files. */
    public Optional<byte[]> embeddedImage(Path texture) {
        return loadedBySource.values().stream()
                .map(loaded -> loaded.file().embeddedImages().get(texture))
                .filter(Objects::nonNull)
                .findFirst();
    }

    /** Where a mesh of its file is. */
    MeshPlace place(Mesh mesh, int number) {
        return loaded(mesh).places().get(number);
    }

    private Loaded loaded(Mesh mesh) {
        Loaded loaded = loadedBySource.get(Source.of(mesh));
        if (loaded == null) {
            throw new IllegalArgumentException("the mesh " + mesh.file() + " was not read");
        }
        return loaded;
    }
}
