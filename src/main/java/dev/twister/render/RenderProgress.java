package dev.twister.render;

import java.nio.file.Path;

/** Follows a rendering, on its thread. An exception of any method ends the rendering. */
public interface RenderProgress {
    /** Ignores everything. */
    RenderProgress SILENT = new RenderProgress() {};

    /**
     * Steps of the simulation before frame 0 are done.
     *
     * @param done number of them
     * @param all number of steps before frame 0
     */
    default void settling(int done, int all) {}

    /** The first picture begins. */
    default void begin() {}

    /** Bodies were simulated to the next frame. */
    default void moved() {}

    /**
     * Bands of rows of a picture are done. Not called for pictures of a single band.
     *
     * @param engine its id
     * @param done number of bands; 0 at first
     * @param all number of bands of the picture
     */
    default void bands(String engine, int done, int all) {}

    /**
     * A frame of an earlier run is not kept; it is rendered again.
     *
     * @param why the rest of a sentence that begins with the file
     */
    default void replacing(Path file, String why) {}

    /** A frame is rendered, or kept; it may not be written yet. */
    default void frame() {}
}
