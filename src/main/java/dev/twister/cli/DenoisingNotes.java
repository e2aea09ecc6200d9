package dev.twister.cli;

import dev.twister.files.PrintableText;
import dev.twister.render.DenoisedPicture;
import java.io.PrintWriter;

/** What a user should know of a picture that was denoised. */
final class DenoisingNotes {
    private DenoisingNotes() {}

    /**
     * Prints a line for each weakness.
     *
     * @param name of the picture
     */
    static void print(DenoisedPicture denoised, String name, PrintWriter err) {
        if (!denoised.guided()) {
            err.println("twister: " + PrintableText.line(name)
                    + " has no guides (guide-albedo and guide-normal), so edges and textures may be blurred;"
                    + " render with --guides");
        }
        if (denoised.notFinite() > 0) {
            err.println("twister: " + PrintableText.line(name) + " has " + denoised.notFinite()
                    + " values that are not finite; they count as 0");
        }
        if (denoised.kept() > 0) {
            err.println("twister: " + PrintableText.line(name) + ": " + denoised.kept()
                    + " values are too large to be denoised; they stay as they are");
        }
    }
}
