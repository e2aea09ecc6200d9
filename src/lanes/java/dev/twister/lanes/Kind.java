package dev.twister.lanes;

/** What a value is: a float, an int, or a condition. A condition is the ints 1 and 0, too. */
enum Kind {
    FLOAT("FloatVector", "f", "FLOATS", "0f"),
    INT("IntVector", "i", "INTS", "0"),
    MASK("VectorMask<Float>", "m", "FLOATS", "false");

    /** The type of its lanes. */
    final String type;

    /** How names of its variables begin. */
    final String letter;

    /** The species of its lanes. */
    final String species;

    /** What a variable holds before it is set. */
    final String zero;

    Kind(String type, String letter, String species, String zero) {
        this.type = type;
        this.letter = letter;
        this.species = species;
        this.zero = zero;
    }
}
