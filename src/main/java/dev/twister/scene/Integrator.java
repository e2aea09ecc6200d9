package dev.twister.scene;

/** How light is followed. */
public enum Integrator {
    /** The paper's: reflections and refractions of the view ray, one light with its shadows, ambient light. */
    WHITTED,
    /** Path tracing: light from everywhere, over any number of surfaces. */
    PATH;

    /** Whether its pictures are noisy until they have many samples. */
    public boolean isNoisy() {
        return this == PATH;
    }
}
