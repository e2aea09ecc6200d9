package dev.twister.gui.drawing;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.Shape;
import dev.twister.world.SceneMeshes;
import dev.twister.world.SceneMeshes.Source;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The meshes of the scene that is drawn. Files are read on a thread of their own: a request gets what is at hand, and
 * draws the rest once {@link #edition} has changed. Used by any thread; none waits for a file.
 */
public final class MeshCache {
    private final Function<Source, MeshFile> reader;
    private final SequencedMap<Source, Mesh> meshBySource = new LinkedHashMap<>();
    private final Map<Source, String> complaints = new LinkedHashMap<>();
    private SceneMeshes held = SceneMeshes.NONE;
    private Optional<Task> task = Optional.empty();
    private Optional<Kept> kept = Optional.empty();
    private long document = -1;
    private volatile long edition;

    /** What is being read; the thread looks again and again whether it still is. */
    private static final class Task {
        private final List<Mesh> missing;
        private volatile String progress = "";

        Task(List<Mesh> missing) {
            this.missing = missing;
        }
    }

    private record Kept(Source source, MeshFile file) {}

    /** @param reader reads a file, as {@link SceneMeshes#reader} does */
    public MeshCache(Function<Source, MeshFile> reader) {
        this.reader = reader;
    }

    /** Keeps a file that was already read for the next scene or edit that names it, unless it is loaded. */
    public synchronized void keep(Mesh mesh, MeshFile file) {
        kept = Optional.of(new Kept(Source.of(mesh), file)).filter(one -> !meshBySource.containsKey(one.source()));
        // It was read, so earlier complaints about it no longer hold.
        complaints.remove(Source.of(mesh));
    }

    /**
     * The loaded meshes, and the scene's shapes; starts reading its other ones.
     *
     * @param newDocument grows with each opened scene, whose files are read again; meshes of an older one are not
     *     available
     */
    synchronized SceneMeshes of(Scene scene, long newDocument) {
        if (newDocument < document) {
            return SceneMeshes.NONE;
        }
        if (newDocument > document) {
            startAnew(newDocument);
        }
        if (task.isEmpty()) {
            Map<Boolean, List<Mesh>> missing = missing(scene).stream()
                    .collect(Collectors.partitioningBy(mesh -> mesh.geometry() instanceof Shape));
            take(missing.get(true));
            if (!missing.get(false).isEmpty()) {
                begin(missing.get(false));
            }
        }
        return held;
    }

    /** Changes when a mesh is loaded or fails to load. */
    public long edition() {
        return edition;
    }

    /** The mesh that is being read, such as {@code knot.obj (1 of 3)}; empty if none is. */
    public synchronized Optional<String> progress() {
        return task.map(now -> now.progress);
    }

    /** Those that are being read are not shown, and not read again before the scene is opened again. */
    public synchronized void cancel() {
        task.ifPresent(canceled -> {
            canceled.missing.forEach(mesh -> complaints.put(
                    Source.of(mesh), mesh.geometry() + ": reading was canceled; open the scene again to see it"));
            task = Optional.empty();
            edition++;
        });
    }

    /** Why meshes of the scene are not shown, if some are not. */
    synchronized Optional<String> complaint(Scene scene) {
        return Optional.of(scene.meshes().stream()
                        .map(Source::of)
                        .distinct()
                        .filter(complaints::containsKey)
                        .map(complaints::get)
                        .collect(Collectors.joining("; ")))
                .filter(all -> !all.isEmpty());
    }

    private void startAnew(long newDocument) {
        document = newDocument;
        task = Optional.empty();
        held = SceneMeshes.NONE;
        meshBySource.clear();
        complaints.clear();
    }

    private List<Mesh> missing(Scene scene) {
        SequencedMap<Source, Mesh> missing = new LinkedHashMap<>();
        for (Mesh mesh : scene.meshes()) {
            Source source = Source.of(mesh);
            if (!meshBySource.containsKey(source) && !complaints.containsKey(source)) {
                missing.putIfAbsent(source, mesh);
            }
        }
        return List.copyOf(missing.values());
    }

    /** Shapes are at hand at once, so that no picture is drawn of a scene without its walls. */
    private void take(List<Mesh> shapes) {
        if (!shapes.isEmpty()) {
            tell(complaints, shapes, () -> {
                List<Mesh> all = new ArrayList<>(meshBySource.values());
                all.addAll(shapes);
                held = held.changedTo(all, reader);
                shapes.forEach(mesh -> meshBySource.put(Source.of(mesh), mesh));
            });
        }
    }

    private void begin(List<Mesh> missing) {
        Task begun = new Task(missing);
        begun.progress = name(missing.getFirst());
        task = Optional.of(begun);
        Thread.ofPlatform().daemon().name("meshes").start(() -> read(begun));
    }

    private void read(Task mine) {
        Map<Source, MeshFile> files = new HashMap<>();
        Map<Source, String> problems = new HashMap<>();
        int count = mine.missing.size();
        for (int i = 0; i < count && isWanted(mine); i++) {
            Mesh mesh = mine.missing.get(i);
            mine.progress = name(mesh) + (count == 1 ? "" : " (" + (i + 1) + " of " + count + ")");
            tell(problems, List.of(mesh), () -> files.put(Source.of(mesh), file(Source.of(mesh))));
        }
        List<Mesh> found = mine.missing.stream()
                .filter(mesh -> files.containsKey(Source.of(mesh)))
                .toList();
        if (isWanted(mine)) {
            long triangles =
                    files.values().stream().mapToLong(MeshFile::shownTriangles).sum();
            mine.progress = (count == 1 ? name(mine.missing.getFirst()) : count + " meshes")
                    + String.format(Locale.ROOT, ", %,d triangles", triangles);
            tell(problems, found, () -> finish(mine, found, joined(found, files)));
        }
        end(mine, problems);
    }

    /** Does that, and what goes wrong then is to be said of those meshes. */
    private static void tell(Map<Source, String> problems, List<Mesh> meshes, Runnable step) {
        try {
            step.run();
        } catch (MeshException problem) {
            meshes.forEach(mesh -> problems.put(Source.of(mesh), problem.getMessage()));
        } catch (OutOfMemoryError _) {
            meshes.forEach(mesh ->
                    problems.put(Source.of(mesh), mesh.geometry() + ": there is not enough memory for this mesh"));
        } catch (RuntimeException | Error problem) {
            meshes.forEach(
                    mesh -> problems.put(Source.of(mesh), mesh.geometry() + ": this mesh cannot be read: " + problem));
        }
    }

    private SceneMeshes joined(List<Mesh> found, Map<Source, MeshFile> files) {
        SceneMeshes before;
        List<Mesh> all;
        synchronized (this) {
            before = held;
            all = new ArrayList<>(meshBySource.values());
        }
        all.addAll(found);
        return before.changedTo(all, files::get);
    }

    private synchronized void finish(Task mine, List<Mesh> found, SceneMeshes joined) {
        if (isWanted(mine)) {
            found.forEach(mesh -> meshBySource.put(Source.of(mesh), mesh));
            held = joined;
        }
    }

    private synchronized void end(Task mine, Map<Source, String> problems) {
        if (isWanted(mine)) {
            complaints.putAll(problems);
            task = Optional.empty();
            edition++;
        }
    }

    private MeshFile file(Source source) {
        return takeKept(source).orElseGet(() -> reader.apply(source));
    }

    private synchronized Optional<MeshFile> takeKept(Source source) {
        Optional<MeshFile> file =
                kept.filter(one -> one.source().equals(source)).map(Kept::file);
        kept = file.isPresent() ? Optional.empty() : kept;
        return file;
    }

    private synchronized boolean isWanted(Task mine) {
        return task.filter(mine::equals).isPresent();
    }

    private static String name(Mesh mesh) {
        return mesh.geometry().name();
    }
}
