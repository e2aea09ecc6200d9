package dev.twister.scene;

/** How a value changes from a keyframe to the next. */
public enum Easing {
    /** Without corners; slow at the film's ends and where it turns back, and never beyond the keyframes' values. */
    SMOOTH,
    /** At constant speed. */
    LINEAR,
    /** Not at all; it jumps at the next keyframe. */
    HOLD
}
