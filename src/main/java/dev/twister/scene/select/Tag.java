package dev.twister.scene.select;

import static java.util.Objects.requireNonNull;

import dev.twister.scene.property.Copied;

/**
 * What a body or a light is called, and how it is kept while a scene is edited.
 *
 * @param name may be empty
 * @param group the name of the group that it is listed under; empty for none
 * @param hidden not in pictures, films and simulations, see {@link VisibleBodies}
 * @param locked not selected by pointing at it, and not moved or deleted with others
 */
@Copied
public record Tag(String name, String group, boolean hidden, boolean locked) implements TagCopy.With {
    /** Without a name and a group, seen and free. */
    public static final Tag NONE = new Tag("", "", false, false);

    public Tag {
        requireNonNull(name, "name");
        requireNonNull(group, "group");
    }
}
