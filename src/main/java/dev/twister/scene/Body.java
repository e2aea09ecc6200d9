package dev.twister.scene;

import dev.twister.scene.select.Tag;

/** A body that a scene may have any number of: it is inserted, moved, copied and deleted. */
public sealed interface Body permits Sphere, Mesh {
    /** What it is called in a sentence. */
    String kind();

    /** The center of a sphere, the origin of a mesh's file, in meters. */
    Vector3 position();

    Body withPosition(Vector3 newPosition);

    Tag tag();

    Body withTag(Tag newTag);
}
