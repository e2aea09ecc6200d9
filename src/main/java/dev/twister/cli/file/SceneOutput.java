package dev.twister.cli.file;

import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneWriter;
import java.io.PrintWriter;
import java.nio.file.Path;

/** Where a command writes a scene: a file, or {@code -} for standard output. */
public final class SceneOutput {
    private SceneOutput() {}

    /** Checks that the output can be written; returns whether it is a file. */
    public static boolean check(Path output) {
        if (OutputFile.isStandardOutput(output)) {
            return false;
        }
        OutputFile.check("--output", output);
        return true;
    }

    public static void write(Scene scene, Path output, PrintWriter out) {
        if (OutputFile.isStandardOutput(output)) {
            out.print(SceneWriter.text(scene));
            out.flush();
        } else {
            SceneWriter.write(scene, output);
        }
    }
}
