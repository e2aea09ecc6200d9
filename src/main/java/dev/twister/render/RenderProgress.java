package dev.twister.render;

/** Hears how far a rendering is, on the thread that renders. Whatever it throws ends the rendering. */
public interface RenderProgress {
    /** Nobody wants to know. */
    RenderProgress SILENT = new RenderProgress() {};

    /**
     * Some of a picture's bands of rows are there. Not called for pictures of a single band.
     *
     * @param engine the id of what draws
     * @param done how many of them; at first 0
     * @param all how many the picture has
     */
    default void bands(String engine, int done, int all) {}

    /** A frame of a film is there. */
    default void frame() {}
}
