package dev.twister.mesh;

import java.util.List;

/** What moves the parts and the vertices of a mesh file: its animations. */
public interface MeshRig {
    /** Of a file that has none. */
    MeshRig NONE = new MeshRig() {
        @Override
        public List<Clip> clips() {
            return List.of();
        }

        @Override
        public MeshFile posed(MeshFile rest, int clip, double seconds) {
            return rest;
        }

        @Override
        public FileSurroundings surroundings(MeshFile rest, int clip, double seconds) {
            return rest.surroundings();
        }
    };

    /** The animations, in the file's order. */
    List<Clip> clips();

    /**
     * The file at a time of one of its animations. It has as many parts and meshes; a mesh whose vertices are where
     * they are at rest is the same object.
     *
     * @param rest the file that has this rig
     * @param clip number of the animation, from 0
     * @param seconds at least 0
     */
    MeshFile posed(MeshFile rest, int clip, double seconds);

    /** The lights and cameras alone of {@link #posed}. */
    FileSurroundings surroundings(MeshFile rest, int clip, double seconds);

    /**
     * An animation.
     *
     * @param name may be empty
     * @param seconds the time of its last key
     */
    record Clip(String name, double seconds) {}
}
