package dev.twister.scene.select;

/**
 * What a scene is called.
 *
 * @param name short, may be empty
 * @param description a sentence for a person, may be empty
 */
public record Title(String name, String description) {
    public static final Title NONE = new Title("", "");

    public Title withName(String newName) {
        return new Title(newName, description);
    }

    public Title withDescription(String newDescription) {
        return new Title(name, newDescription);
    }
}
