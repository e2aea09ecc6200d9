package dev.twister.gui.model;

import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneLimits;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;

/** A sphere or a mesh: what a person inserts, moves, copies and deletes. */
public sealed interface Solid {
    /** What it is called in a sentence. */
    String kind();

    /** Its place in the scene, in meters. */
    Vector3 position();

    Solid withPosition(Vector3 position);

    /** The scene with this one as the last of its kind. */
    default Scene insertedInto(Scene scene) {
        return inserted(scene, List.of(this));
    }

    /** The scene with those, in their order, as the last of their kinds. */
    static Scene inserted(Scene scene, List<Solid> bodies) {
        List<Sphere> spheres = new ArrayList<>(scene.spheres());
        List<Mesh> meshes = new ArrayList<>(scene.meshes());
        for (Solid body : bodies) {
            switch (body) {
                case OfSphere(Sphere sphere) -> spheres.add(sphere);
                case OfMesh(Mesh mesh) -> meshes.add(mesh);
            }
        }
        return scene.withSpheres(spheres).withMeshes(meshes);
    }

    /** The numbers of those, once they are {@link #inserted}. */
    static List<Integer> numbers(Scene inserted, List<Solid> bodies) {
        int meshes = (int) bodies.stream().filter(OfMesh.class::isInstance).count();
        int sphere = inserted.spheres().size() - (bodies.size() - meshes);
        int mesh = inserted.meshes().size() - meshes;
        List<Integer> numbers = new ArrayList<>();
        for (Solid body : bodies) {
            switch (body) {
                case OfSphere _ -> numbers.add(BodyNumber.ofSphere(sphere++));
                case OfMesh _ -> numbers.add(BodyNumber.ofMesh(mesh++));
            }
        }
        return numbers;
    }

    /** The same so far to the right, in meters. */
    default Solid beside(double apart) {
        Vector3 place = position();
        return withPosition(new Vector3(SceneLimits.POSITION.clamp(place.x() + apart), place.y(), place.z()));
    }

    record OfSphere(Sphere sphere) implements Solid {
        @Override
        public String kind() {
            return "sphere";
        }

        @Override
        public Vector3 position() {
            return sphere.position();
        }

        @Override
        public Solid withPosition(Vector3 position) {
            return new OfSphere(sphere.withPosition(position));
        }
    }

    record OfMesh(Mesh mesh) implements Solid {
        @Override
        public String kind() {
            return "mesh";
        }

        @Override
        public Vector3 position() {
            return mesh.position();
        }

        @Override
        public Solid withPosition(Vector3 position) {
            return new OfMesh(mesh.withPosition(position));
        }
    }
}
