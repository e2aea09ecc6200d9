package dev.twister.gui.model;

import dev.twister.kernel.Layout;

/** How the window numbers a scene's bodies: as a picture of it does. */
public final class BodyNumber {
    /** No body: the sky is seen there, or nothing is selected. */
    public static final int NONE = Layout.NOTHING;

    public static final int LIGHT = Layout.LIGHT;

    public static final int PLANE = Layout.PLANE;

    private BodyNumber() {}

    /** The number of the sphere at that place of the scene's list. */
    public static int ofSphere(int index) {
        return Layout.FIRST_SPHERE + index;
    }

    /** The sphere's place in the scene's list; below 0 for what is no sphere. */
    public static int sphere(int body) {
        return body - Layout.FIRST_SPHERE;
    }
}
