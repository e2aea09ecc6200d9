package dev.twister.scene.select;

import dev.twister.scene.property.Copied;

/**
 * What a scene is called.
 *
 * @param name short, may be empty
 * @param description a sentence for a person, may be empty
 */
@Copied
public record Title(String name, String description) implements TitleCopy.With {
    public static final Title NONE = new Title("", "");
}
