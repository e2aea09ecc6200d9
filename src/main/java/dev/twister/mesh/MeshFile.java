package dev.twister.mesh;

import dev.twister.mesh.input.QuotedText;
import dev.twister.scene.MeshAnimation;
import dev.twister.scene.Vector3;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The content of a mesh file.
 *
 * @param meshes distinct meshes; several parts may share one
 * @param parts at least one
 * @param embeddedImages PNG, JPEG or WebP data in the file, by the texture path of the parts' materials: the file's own
 *     path, followed by the image's number
 * @param degenerateTriangles number of dropped triangles without area
 * @param surroundings the lights and cameras of a glTF file's scene
 * @param rig the file's animations
 */
public record MeshFile(
        List<TriangleMesh> meshes,
        List<MeshPart> parts,
        Map<Path, byte[]> embeddedImages,
        int degenerateTriangles,
        FileSurroundings surroundings,
        MeshRig rig) {
    public MeshFile {
        meshes = List.copyOf(meshes);
        parts = List.copyOf(parts);
        embeddedImages = Map.copyOf(embeddedImages);
    }

    /** Without lights, cameras and animations. */
    public MeshFile(
            List<TriangleMesh> meshes,
            List<MeshPart> parts,
            Map<Path, byte[]> embeddedImages,
            int degenerateTriangles) {
        this(meshes, parts, embeddedImages, degenerateTriangles, FileSurroundings.NONE, MeshRig.NONE);
    }

    /**
     * The number of an animation.
     *
     * @param name the animation's name, or its number from 0 as text
     */
    public OptionalInt clip(String name) {
        List<MeshRig.Clip> clips = rig.clips();
        OptionalInt named = IntStream.range(0, clips.size())
                .filter(clip -> !name.isEmpty() && clips.get(clip).name().equals(name))
                .findFirst();
        return named.isPresent()
                ? named
                : IntStream.range(0, clips.size())
                        .filter(clip -> name.equals(Integer.toString(clip)))
                        .findFirst();
    }

    /** For each animation, in the file's order, its name, or its number where no {@link #clip} finds it by a name. */
    public List<String> clips() {
        return IntStream.range(0, rig.clips().size())
                .mapToObj(clip -> clip(rig.clips().get(clip).name()).equals(OptionalInt.of(clip))
                        ? rig.clips().get(clip).name()
                        : Integer.toString(clip))
                .toList();
    }

    /** The numbers and names of the animations, for people. */
    public String clipNames() {
        return IntStream.range(0, rig.clips().size())
                .mapToObj(clip -> rig.clips().get(clip).name().isEmpty()
                        ? Integer.toString(clip)
                        : clip + " (" + QuotedText.text(rig.clips().get(clip).name()) + ")")
                .collect(Collectors.joining(", "));
    }

    /** Why there is no animation of that name; empty if there is one. */
    public Optional<String> complaint(String name) {
        if (clip(name).isPresent()) {
            return Optional.empty();
        }
        return Optional.of(
                rig.clips().isEmpty()
                        ? "the file has no animations"
                        : "the file has no animation " + QuotedText.text(name) + "; expected one of: " + clipNames());
    }

    /** The length of an animation, in seconds; 0 if there is none of that name. */
    public double clipSeconds(MeshAnimation animation) {
        OptionalInt clip = clip(animation.name());
        return clip.isPresent() ? rig.clips().get(clip.getAsInt()).seconds() : 0;
    }

    /** The file at the start of one of its animations; as it is if there is none of that name. */
    public MeshFile posed(MeshAnimation animation) {
        OptionalInt clip = clip(animation.name());
        return clip.isPresent() ? rig.posed(this, clip.getAsInt(), animation.time(clipSeconds(animation))) : this;
    }

    /** The lights and cameras at the start of one of the animations. */
    FileSurroundings surroundings(MeshAnimation animation) {
        OptionalInt clip = clip(animation.name());
        return clip.isPresent()
                ? rig.surroundings(this, clip.getAsInt(), animation.time(clipSeconds(animation)))
                : surroundings;
    }

    /** The box around all parts. */
    public Box bounds() {
        return bounds(Affine.IDENTITY);
    }

    /**
     * The box around all parts.
     *
     * @param turn applied to the file's coordinates first
     */
    public Box bounds(Affine turn) {
        Box bounds = Box.NONE;
        for (MeshPart part : parts) {
            Affine placement = turn.of(part.placement());
            float[] positions = meshes.get(part.mesh()).positions();
            for (int at = 0; at < positions.length; at += 3) {
                bounds = bounds.with(placement.point(new Vector3(positions[at], positions[at + 1], positions[at + 2])));
            }
        }
        return bounds;
    }

    /** Number of triangles of all parts; triangles of a shared mesh count for each part. */
    public long shownTriangles() {
        return parts.stream()
                .mapToLong(part -> meshes.get(part.mesh()).triangles())
                .sum();
    }
}
