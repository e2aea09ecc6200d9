package dev.twister.lanes;

/** The kernel has what lanes cannot be made of. */
final class Refusal extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final boolean hasPlace;

    /** Refuses something whose place is added later. */
    Refusal(String what) {
        super(what);
        hasPlace = false;
    }

    private Refusal(String what, Refusal cause) {
        super(what, cause);
        hasPlace = true;
    }

    /** This one with its place, such as {@code Noise.java:52}, unless it has one. */
    Refusal at(String place) {
        return hasPlace ? this : new Refusal(place + ": " + getMessage(), this);
    }
}
