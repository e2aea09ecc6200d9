package dev.twister.cli;

import dev.twister.render.RenderProgress;

/** Shows how many frames of a film are drawn. */
record FrameLine(ProgressLine line) implements RenderProgress {
    @Override
    public void frame() {
        line.step();
    }
}
