package dev.twister.render;

import dev.twister.engine.ConvergingPicture.Convergence;
import java.nio.file.Path;
import java.util.Optional;

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
     * A part of a picture is done. Not called for pictures that are drawn in one go.
     *
     * @param engine its id
     * @param part of the whole picture, in (0, 1]
     * @param pass the samples so far of the rows being drawn, and their noise; empty if whole rows are finished
     */
    default void part(String engine, double part, Optional<Convergence> pass) {}

    /**
     * A frame of an earlier run is not kept; it is rendered again.
     *
     * @param why the rest of a sentence that begins with the file
     */
    default void replacing(Path file, String why) {}

    /**
     * Whether the rendering is to end soon, by a {@link dev.twister.image.RenderStoppedException}. Asked by several
     * threads while a picture is rendered; once true, it must stay true.
     */
    default boolean isStopped() {
        return false;
    }

    /** A frame is rendered, or kept; it may not be written yet. */
    default void frame() {}
}
