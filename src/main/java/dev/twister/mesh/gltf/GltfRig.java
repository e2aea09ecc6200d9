package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.FileSurroundings;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.MeshRig;
import dev.twister.mesh.TriangleMesh;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The animations of a glTF file, and what they move.
 *
 * @param parts the part of each of the file's parts
 * @param meshes those of the file's meshes whose vertices move, by their number
 */
record GltfRig(
        List<GltfAnimation> animations,
        GltfSkeleton skeleton,
        List<Part> parts,
        Map<Integer, GltfDeformed> meshes,
        GltfSurroundings.Carriers carriers)
        implements MeshRig {
    /** Of a part that would leave the range of coordinates. */
    private static final Affine NOWHERE = new Affine(Vector3.ZERO, Vector3.ZERO, Vector3.ZERO, Vector3.ZERO);

    /**
     * What places a part.
     *
     * @param node that has it; empty where a skin places it, or nothing
     * @param instance transform to the node's coordinates
     * @param primitive transform from the mesh's coordinates, in Twister's axes
     */
    record Part(Optional<Integer> node, Affine instance, Affine primitive) {}

    GltfRig {
        animations = List.copyOf(animations);
        parts = List.copyOf(parts);
        meshes = Map.copyOf(meshes);
    }

    @Override
    public List<Clip> clips() {
        return animations.stream()
                .map(animation -> new Clip(animation.name(), animation.seconds()))
                .toList();
    }

    @Override
    public MeshFile posed(MeshFile rest, int clip, double seconds) {
        Map<Integer, double[]> weights = new HashMap<>();
        Map<Integer, Affine> now = placements(clip, seconds, weights);
        Map<Integer, Affine> before = skeleton.placements(skeleton.numbers());
        List<TriangleMesh> moved = new ArrayList<>(rest.meshes());
        meshes.forEach((mesh, deformed) -> moved.set(mesh, moved(moved.get(mesh), deformed, weights, before, now)));
        return new MeshFile(
                moved,
                placed(rest.parts(), now),
                rest.embeddedImages(),
                rest.degenerateTriangles(),
                carriers.placed(rest.surroundings(), now),
                this);
    }

    @Override
    public FileSurroundings surroundings(MeshFile rest, int clip, double seconds) {
        return carriers.placed(rest.surroundings(), placements(clip, seconds, new HashMap<>()));
    }

    /**
     * Where the nodes are at a time of an animation.
     *
     * @param weights receives those of morph targets that the animation changes, by their node
     */
    private Map<Integer, Affine> placements(int clip, double seconds, Map<Integer, double[]> weights) {
        double[] numbers = skeleton.numbers();
        for (GltfAnimation.Channel channel : animations.get(clip).channels()) {
            GltfSampler sampler = channel.sampler();
            if (channel.isOfWeights()) {
                double[] now = new double[sampler.components()];
                sampler.write(seconds, now, 0);
                weights.put(channel.node(), now);
            } else if (skeleton.has(channel.node())) {
                sampler.write(seconds, numbers, skeleton.first(channel.node()) + channel.first());
            }
        }
        return skeleton.placements(numbers);
    }

    /** A mesh with its vertices moved; the same one if they are where they are at rest. */
    private static TriangleMesh moved(
            TriangleMesh rest,
            GltfDeformed deformed,
            Map<Integer, double[]> weights,
            Map<Integer, Affine> before,
            Map<Integer, Affine> now) {
        GltfPose pose = deformed.pose();
        Optional<double[]> animated = pose.node().isPresent()
                ? Optional.ofNullable(weights.get(pose.node().getAsInt()))
                : Optional.empty();
        List<Affine> movements = movements(deformed, now);
        boolean moves = animated.isPresent() || !movements.equals(movements(deformed, before));
        return moves ? deformed.moved(rest, animated.orElseGet(pose::weightArray), movements) : rest;
    }

    private static List<Affine> movements(GltfDeformed deformed, Map<Integer, Affine> placements) {
        return deformed.deformation()
                .binding()
                .map(binding -> binding.skin().movements(placements::get))
                .orElse(List.of());
    }

    private List<MeshPart> placed(List<MeshPart> rest, Map<Integer, Affine> placements) {
        List<MeshPart> placed = new ArrayList<>();
        for (int i = 0; i < rest.size(); i++) {
            MeshPart before = rest.get(i);
            Part part = parts.get(i);
            placed.add(part.node()
                    .map(node -> GltfTransform.turned(placements.get(node).of(part.instance())))
                    .map(placement -> GltfTransform.isNear(placement) ? placement : NOWHERE)
                    .map(placement -> new MeshPart(
                            before.name(), before.mesh(), placement.of(part.primitive()), before.material()))
                    .orElse(before));
        }
        return placed;
    }
}
