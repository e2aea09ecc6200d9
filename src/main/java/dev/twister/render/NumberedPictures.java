package dev.twister.render;

import dev.twister.image.Provenance;
import dev.twister.world.FrameInput;
import java.io.IOException;
import java.util.List;

/** Frames in numbered files, all of which are written anew. */
public record NumberedPictures(NumberedFiles files, PictureFormat format) implements FrameRendering.Target {
    @Override
    public boolean keeps(int number, Provenance made, FrameInput part) {
        return false;
    }

    @Override
    public void write(int number, List<DrawnPicture> drawn, FrameInput part, Provenance made) throws IOException {
        format.write(files.file(number), drawn, part, made);
    }

    @Override
    public boolean isOrdered() {
        return false;
    }
}
