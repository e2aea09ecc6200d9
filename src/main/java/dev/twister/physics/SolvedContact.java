package dev.twister.physics;

/**
 * A contact while it is solved: two bodies that meet, or a body and a fixed surface. A mutable object that one thread
 * reuses for many contacts.
 */
final class SolvedContact {
    /** Of a list of contacts, see {@link Contacts#impulses}. */
    double[] impulses;

    ContactRules rules;

    /** Start of this contact's impulses. */
    int at;

    /** Start of each body's values in {@link BodyStore#numbers}; of a surface, the second one is not used. */
    int first;

    int second;

    /** Unit vector toward the first body. */
    double normalX;

    double normalY;
    double normalZ;

    /** Displacement of the first body relative to the second one. */
    double moveX;

    double moveY;
    double moveZ;

    /** For impacts: from the second body's center to the first one's, in meters. */
    double placeX;

    double placeY;
    double placeZ;

    /** For impacts: squared distance of the centers minus the squared sum of the radii. */
    double outside;

    /** For impacts: the product of place and move, negative if the bodies approach each other. */
    double closing;

    SolvedContact(double[] impulses, ContactRules rules) {
        this.impulses = impulses;
        this.rules = rules;
    }

    /** Continues with the contacts of a list. */
    void start(double[] newImpulses, ContactRules newRules) {
        impulses = newImpulses;
        rules = newRules;
    }

    /** The component of the accumulated impulse along the normal, see {@link Contacts#BUILT}. */
    double built() {
        return impulses[at + Contacts.BUILT];
    }

    void setBuilt(double built) {
        impulses[at + Contacts.BUILT] = built;
    }

    /** Forgets the accumulated impulse. */
    void clear() {
        impulses[at] = 0;
        impulses[at + 1] = 0;
        impulses[at + 2] = 0;
        impulses[at + Contacts.BUILT] = 0;
    }

    /** Multiplies the accumulated impulse's direction by a sign: it then acts on the other body. */
    void turn(double sign) {
        impulses[at] *= sign;
        impulses[at + 1] *= sign;
        impulses[at + 2] *= sign;
    }

    void setNormal(double x, double y, double z) {
        normalX = x;
        normalY = y;
        normalZ = z;
    }

    void setMove(double x, double y, double z) {
        moveX = x;
        moveY = y;
        moveZ = z;
    }

    void setPlace(double x, double y, double z, double newOutside, double newClosing) {
        placeX = x;
        placeY = y;
        placeZ = z;
        outside = newOutside;
        closing = newClosing;
    }

    /** The squared length of the relative displacement. */
    double path() {
        return moveX * moveX + moveY * moveY + moveZ * moveZ;
    }
}
