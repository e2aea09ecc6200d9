package dev.twister.bench;

import dev.twister.image.Frame;

/** A picture of the evaluation, as the reference engine draws it. */
public record PaperPicture(PaperSetting setting, Frame frame) {
    /** The name of its file. */
    public String fileName() {
        return "picture-" + setting.shadowSamples() + "-samples-" + setting.bounces() + "-bounces.png";
    }
}
