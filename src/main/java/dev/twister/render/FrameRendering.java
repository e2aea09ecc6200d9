package dev.twister.render;

import dev.twister.image.Provenance;
import dev.twister.world.FrameInput;
import java.io.IOException;
import java.util.List;

/** Renders the frames of a film into numbered pictures, which are written while the next ones are drawn. */
public final class FrameRendering {
    private static final int MOST_WRITERS = 4;

    private FrameRendering() {}

    /** Where the pictures go. */
    public interface Target {
        /**
         * Whether a frame is there already and is kept.
         *
         * @param part of the picture that it must have
         */
        boolean keeps(int number, Provenance made, FrameInput part);

        /** Writes a frame; called by several threads, of which each writes another one. */
        void write(int number, List<DrawnPicture> drawn, FrameInput part, Provenance made) throws IOException;

        /** Whether they are written one after the other, in the order of their numbers. */
        boolean isOrdered();
    }

    /** How many pictures are in memory at once. */
    public static int picturesKept(boolean ordered) {
        return 1 + WritingBeside.waiting(writers(ordered));
    }

    private static int writers(boolean ordered) {
        return ordered ? 1 : Math.clamp(Runtime.getRuntime().availableProcessors() / 2, 1, MOST_WRITERS);
    }

    /**
     * Renders the frames, each of which is written whole or not at all.
     *
     * @return how many of them were kept
     * @throws IOException as the target, or where the bodies' places cannot be read
     */
    public static int render(
            PictureDrawing drawing, FilmScene shown, FrameRange frames, Target target, RenderProgress progress)
            throws IOException {
        int kept = 0;
        try (WritingBeside writing = new WritingBeside(writers(target.isOrdered()))) {
            for (int number : frames.numbers().toArray()) {
                FrameInput input = shown.frame(number);
                FrameInput part = drawing.part().of(input);
                Provenance made = drawing.provenance(input);
                if (target.keeps(number, made, part)) {
                    kept++;
                } else {
                    List<DrawnPicture> drawn = drawing.draw(input, progress);
                    writing.submit(() -> target.write(number, drawn, part, made));
                }
                progress.frame();
            }
            writing.finish();
        }
        return kept;
    }
}
