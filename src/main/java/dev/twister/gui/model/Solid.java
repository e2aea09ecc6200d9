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
    Scene insertedInto(Scene scene);

    /** The number of the last one of this kind. */
    int last(Scene scene);

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

        @Override
        public Scene insertedInto(Scene scene) {
            return scene.withSpheres(with(scene.spheres(), sphere));
        }

        @Override
        public int last(Scene scene) {
            return BodyNumber.ofSphere(scene.spheres().size() - 1);
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

        @Override
        public Scene insertedInto(Scene scene) {
            return scene.withMeshes(with(scene.meshes(), mesh));
        }

        @Override
        public int last(Scene scene) {
            return BodyNumber.ofMesh(scene.meshes().size() - 1);
        }
    }

    private static <T> List<T> with(List<T> bodies, T another) {
        List<T> more = new ArrayList<>(bodies);
        more.add(another);
        return more;
    }
}
