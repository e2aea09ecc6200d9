package dev.twister.world;

import dev.twister.kernel.Layout;
import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshPlacement;
import dev.twister.mesh.MeshReader;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Geometry;
import dev.twister.scene.Material;
import dev.twister.scene.Mesh;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.scene.Triangles;
import dev.twister.scene.Vector3;
import dev.twister.world.table.FarPoints;
import dev.twister.world.table.MeshGeometry;
import dev.twister.world.table.MeshPlace;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * The mesh files that a scene refers to, each once, with a hierarchy over the triangles of each mesh. It is shared by
 * worlds of the same scene whose meshes are placed differently.
 */
public final class SceneMeshes {
    /** For scenes without meshes. */
    public static final SceneMeshes NONE = new SceneMeshes(new float[1], Map.of());

    private final float[] floats;
    private final Map<Source, Loaded> loadedBySource;

    /** The files at times of their animations; none if all meshes are at rest. */
    private final Map<Pose, Loaded> loadedByPose;

    /** The same meshes at rest. */
    private final Optional<SceneMeshes> rest;

    /** Triangles and the angle on which generated normals depend, or the basis of shapes of many sizes. */
    public record Source(Geometry geometry, double smoothDegrees) {
        public static Source of(Mesh mesh) {
            return switch (mesh.geometry()) {
                case Geometry.OfFile _, Triangles _ -> new Source(mesh.geometry(), mesh.smoothDegrees());
                case Shape shape -> new Source(shape.basis(), 0);
            };
        }
    }

    /** Triangles at a time of an animation. */
    private record Pose(Source source, MeshAnimation animation) {
        static Pose of(Mesh mesh) {
            return new Pose(Source.of(mesh), mesh.animation());
        }
    }

    /**
     * A file and the locations of its meshes.
     *
     * @param places one for each of the file's meshes
     * @param farPoints see {@link FarPoints}
     */
    private record Loaded(MeshFile file, List<MeshPlace> places, Supplier<List<Vector3>> farPoints) {}

    private SceneMeshes(float[] floats, Map<Source, Loaded> loadedBySource) {
        this(floats, loadedBySource, Map.of(), Optional.empty());
    }

    private SceneMeshes(
            float[] floats,
            Map<Source, Loaded> loadedBySource,
            Map<Pose, Loaded> loadedByPose,
            Optional<SceneMeshes> rest) {
        this.floats = floats;
        this.loadedBySource = loadedBySource;
        this.loadedByPose = loadedByPose;
        this.rest = rest;
    }

    /**
     * Reads a scene's mesh files, each once.
     *
     * @param warnings receives one line for each unsupported feature of a file
     * @throws MeshException as for {@link #of}, or if a file has not the animation that a mesh plays
     */
    public static SceneMeshes read(Scene scene, Consumer<String> warnings) {
        SceneMeshes read = of(scene, reader(warnings));
        for (int i = 0; i < scene.meshes().size(); i++) {
            MeshAnimation animation = scene.meshes().get(i).animation();
            if (!animation.isNone()) {
                String place = "meshes[" + i + "].animation: ";
                read.file(scene.meshes().get(i)).complaint(animation.name()).ifPresent(problem -> {
                    throw new MeshException(place + problem);
                });
            }
        }
        return read;
    }

    /** A reader that uses {@link MeshReader#read}. */
    public static Function<Source, MeshFile> reader(Consumer<String> warnings) {
        return source -> MeshReader.read(source.geometry(), source.smoothDegrees(), warnings);
    }

    /**
     * A scene's meshes.
     *
     * @param reader reads a file, like {@link MeshReader#read}
     * @throws MeshException if the reader does, with where the scene file refers to the file in the message; or if all
     *     meshes together exceed the length of an array
     */
    public static SceneMeshes of(Scene scene, Function<Source, MeshFile> reader) {
        return NONE.changedTo(scene.meshes(), reader);
    }

    /**
     * The given meshes; files that are already present are not read again.
     *
     * @throws MeshException as for {@link #of}
     */
    public SceneMeshes changedTo(List<Mesh> meshes, Function<Source, MeshFile> reader) {
        if (rest.isPresent()) {
            return rest.get().changedTo(meshes, reader);
        }
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
                        ? MeshGeometry.of(
                                file.meshes().get(mesh), !file.rig().clips().isEmpty())
                        : before.places().get(mesh).geometry(floats);
                places.add(MeshPlace.of(start, geometry));
                parts.add(geometry.floats());
                start = checked(start + (long) geometry.floats().length);
            }
            List<Vector3> farPoints =
                    before == null ? FarPoints.of(file) : before.farPoints().get();
            loaded.put(entry.getKey(), new Loaded(file, places, () -> farPoints));
        }
        return new SceneMeshes(joined(parts, start), loaded);
    }

    /**
     * The meshes as they are at the start of their animations, with their hierarchies.
     *
     * @param before a result of this method, which is returned again if it is the same
     */
    SceneMeshes posed(List<Mesh> meshes, SceneMeshes before) {
        SceneMeshes atRest = rest.orElse(this);
        Set<Pose> poses = meshes.stream()
                .filter(mesh -> !mesh.animation().isNone() && holds(mesh))
                .map(Pose::of)
                .collect(Collectors.toCollection(LinkedHashSet::new));
        if (poses.isEmpty()) {
            return atRest;
        }
        Set<Source> still = new LinkedHashSet<>(atRest.loadedBySource.keySet());
        poses.forEach(pose -> still.remove(pose.source()));
        meshes.stream()
                .filter(mesh -> mesh.animation().isNone())
                .map(Source::of)
                .forEach(still::add);
        boolean same = before.rest.equals(Optional.of(atRest))
                && before.loadedByPose.keySet().equals(poses);
        return same ? before : new Posing(atRest, still).posed(poses);
    }

    /** Joins meshes at rest and meshes at times of animations. */
    private static final class Posing {
        /** A mesh of a file, as it is at rest. */
        private record Rigid(Source source, int mesh) {}

        private final SceneMeshes rest;
        private final Map<Source, Loaded> still = new LinkedHashMap<>();
        private final Map<Rigid, MeshPlace> rigid = new HashMap<>();
        private final List<float[]> parts = new ArrayList<>();
        private int start;

        /** @param sources those that some mesh shows at rest */
        Posing(SceneMeshes rest, Set<Source> sources) {
            this.rest = rest;
            for (Source source : sources) {
                if (rest.loadedBySource.containsKey(source)) {
                    Loaded loaded = rest.loadedBySource.get(source);
                    still.put(source, new Loaded(loaded.file(), places(source, loaded.file()), loaded.farPoints()));
                }
            }
        }

        SceneMeshes posed(Set<Pose> poses) {
            Map<Pose, Loaded> posed = new LinkedHashMap<>();
            for (Pose pose : poses) {
                Loaded now = at(pose);
                posed.put(pose, now);
                still.putIfAbsent(pose.source(), now);
            }
            return new SceneMeshes(joined(parts, start), still, posed, Optional.of(rest));
        }

        private Loaded at(Pose pose) {
            MeshFile file = rest.loadedBySource.get(pose.source()).file().posed(pose.animation());
            return new Loaded(file, places(pose.source(), file), new FarPoints.Later(file));
        }

        /** A mesh that is as at rest is taken once, whatever the poses are. */
        @SuppressWarnings("ReferenceEquality") // as a rig has it
        private List<MeshPlace> places(Source source, MeshFile file) {
            Loaded loaded = rest.loadedBySource.get(source);
            List<MeshPlace> places = new ArrayList<>();
            for (int mesh = 0; mesh < file.meshes().size(); mesh++) {
                TriangleMesh now = file.meshes().get(mesh);
                MeshPlace before = loaded.places().get(mesh);
                places.add(
                        now == loaded.file().meshes().get(mesh)
                                ? rigid.computeIfAbsent(new Rigid(source, mesh), _ -> add(before.geometry(rest.floats)))
                                : add(before.geometry(rest.floats).moved(now)));
            }
            return places;
        }

        private MeshPlace add(MeshGeometry geometry) {
            MeshPlace place = MeshPlace.of(start, geometry);
            parts.add(geometry.floats());
            start = checked(start + (long) geometry.floats().length);
            return place;
        }
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

    /** The data of all meshes, see {@link Layout}; the same array as long as the meshes are the same. */
    public float[] floats() {
        return floats;
    }

    /** The scene without the meshes that are missing here. */
    public Scene shown(Scene scene) {
        return scene.meshes().stream().allMatch(this::holds)
                ? scene
                : scene.withMeshes(scene.meshes().stream().filter(this::holds).toList());
    }

    /** Whether the mesh's file is present. */
    public boolean holds(Mesh mesh) {
        return loadedBySource.containsKey(Source.of(mesh));
    }

    /** The length of the animation that a mesh plays, in seconds; 0 if that is not known. */
    public double clipSeconds(Mesh mesh) {
        return holds(mesh) ? loaded(mesh).file().clipSeconds(mesh.animation()) : 0;
    }

    /** The names of the animations of a mesh's file, see {@link MeshFile#clips}; none until it has been read. */
    public List<String> clips(Mesh mesh) {
        return holds(mesh) ? loaded(mesh).file().clips() : List.of();
    }

    /** The content of a mesh's file, at the start of its animation. */
    public MeshFile file(Mesh mesh) {
        return loaded(mesh).file();
    }

    /** The same, whatever the animation's start is. */
    public MeshFile posedFile(Mesh mesh) {
        return rest.orElse(this)
                .loaded(mesh.withAnimation(MeshAnimation.NONE))
                .file()
                .posed(mesh.animation());
    }

    /**
     * The vertices of a mesh that are farthest out in many directions, in the scene's coordinates. They approximate its
     * outline from any direction.
     */
    public List<Vector3> farPoints(Mesh mesh) {
        Affine placement = MeshPlacement.of(mesh);
        return loaded(mesh).farPoints().get().stream().map(placement::point).toList();
    }

    /** The number of bodies that a mesh consists of: one per part. */
    public int parts(Mesh mesh) {
        return loaded(mesh).file().parts().size();
    }

    /** The file's name for a part of a mesh; may be empty. */
    public String partName(Mesh mesh, int part) {
        return loaded(mesh).file().parts().get(part).name();
    }

    /** The material of a mesh if the scene gives none: that of its file's first part. */
    public Material fileMaterial(Mesh mesh) {
        Material material = loaded(mesh).file().parts().getFirst().material();
        boolean embedded = material.images().stream()
                .anyMatch(image -> embeddedImage(image).isPresent());
        // No scene file can refer to an embedded image.
        return embedded ? material.withoutImages() : material;
    }

    /**
     * The textures of the files' own materials that meshes of the scene use, with where the scene file refers to the
     * mesh.
     */
    public Map<Path, String> textures(Scene scene) {
        Map<Path, String> placeByTexture = new LinkedHashMap<>();
        for (int i = 0; i < scene.meshes().size(); i++) {
            Mesh mesh = scene.meshes().get(i);
            if (mesh.material().isEmpty()) {
                for (MeshPart part : file(mesh).parts()) {
                    String place = "meshes[" + i + "].file";
                    part.material().images().forEach(texture -> placeByTexture.putIfAbsent(texture, place));
                }
            }
        }
        return placeByTexture;
    }

    /** The PNG, JPEG or WebP data of a texture that is embedded in one of the files. */
    public Optional<byte[]> embeddedImage(Path texture) {
        return loadedBySource.values().stream()
                .map(loaded -> loaded.file().embeddedImages().get(texture))
                .filter(Objects::nonNull)
                .findFirst();
    }

    /** The location of one of the meshes of a mesh's file. */
    public MeshPlace place(Mesh mesh, int number) {
        return loaded(mesh).places().get(number);
    }

    /** The mesh at another time of its animation, if it is not there at the one that is asked for. */
    private Optional<Loaded> anyPose(Mesh mesh) {
        return loadedByPose.entrySet().stream()
                .filter(entry -> entry.getKey().source().equals(Source.of(mesh))
                        && entry.getKey()
                                .animation()
                                .withStart(0)
                                .equals(mesh.animation().withStart(0)))
                .map(Map.Entry::getValue)
                .findFirst();
    }

    private Loaded loaded(Mesh mesh) {
        Optional<Loaded> moving = mesh.animation().isNone()
                ? Optional.empty()
                : Optional.ofNullable(loadedByPose.get(Pose.of(mesh))).or(() -> anyPose(mesh));
        Loaded loaded = moving.orElseGet(() -> loadedBySource.get(Source.of(mesh)));
        if (loaded == null) {
            throw new IllegalArgumentException("the mesh " + mesh.geometry() + " was not read");
        }
        return loaded;
    }
}
