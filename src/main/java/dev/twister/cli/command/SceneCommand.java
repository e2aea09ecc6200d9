package dev.twister.cli.command;

import dev.twister.cli.file.ExitCode;
import dev.twister.cli.file.Home;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SceneOutput;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.option.Ranges;
import dev.twister.cli.option.SkyOptions;
import dev.twister.files.PrintableText;
import dev.twister.mesh.MeshFile;
import dev.twister.scene.Mesh;
import dev.twister.scene.Scene;
import dev.twister.scene.format.TexturePlaces;
import dev.twister.scene.generate.SceneGenerator;
import dev.twister.sky.ShippedSky;
import dev.twister.world.SceneMeshes;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code twister scene}: makes scenes, and checks them. */
@Command(
        name = "scene",
        description = "Makes a scene of many spheres, or checks a scene file with its skybox, textures and meshes.",
        footer = {
            "",
            "Examples:",
            "  twister scene --spheres 10000 --seed 1 -o vortex.json",
            "  twister scene --check my-scene.json"
        })
final class SceneCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @ArgGroup(multiplicity = "1")
    private Task task;

    /** What to do: one or the other. */
    static final class Task {
        @Option(
                names = "--check",
                required = true,
                paramLabel = "FILE",
                description = "Check this scene file, or - for standard input, and say where and why it is not valid.")
        private Optional<String> checked = Optional.empty();

        @ArgGroup(exclusive = false)
        private Generation generation;
    }

    /** What a made scene depends on. */
    static final class Generation {
        @Option(
                names = "--spheres",
                required = true,
                paramLabel = "N",
                description = "Number of spheres, 1 to " + SceneGenerator.MAX_SPHERES + ".")
        private int count;

        @Option(names = "--seed", paramLabel = "N", description = "Random seed (default: 1).")
        private long seed = 1;

        @ArgGroup(exclusive = false)
        private SkyOptions sky = new SkyOptions();

        @Option(
                names = {"-o", "--output"},
                required = true,
                paramLabel = "FILE",
                description = "The scene file; - for standard output.")
        private Path output;
    }

    @Override
    public Integer call() throws IOException {
        if (task.checked.isPresent()) {
            say(check(task.checked.get()));
        } else {
            generate(task.generation);
        }
        return ExitCode.OK;
    }

    private void say(String done) {
        spec.commandLine().getOut().println(PrintableText.line(done));
    }

    private String check(String name) {
        Path file = SceneFiles.find(name);
        Scene scene = SceneFiles.read(file);
        SceneMeshes meshes = SkyFiles.world(scene, spec.commandLine().getErr()).meshes();
        return SceneFiles.name(file) + ": valid, " + spheres(scene)
                + also(scene.materials().size(), "material")
                + also(TexturePlaces.of(scene).size(), "texture")
                + meshes(scene, meshes);
    }

    private static String meshes(Scene scene, SceneMeshes meshes) {
        StringBuilder text = new StringBuilder();
        for (Mesh mesh : scene.meshes()) {
            MeshFile held = meshes.file(mesh);
            text.append("; %s: %d triangles".formatted(mesh.geometry().name(), held.shownTriangles()))
                    .append(also(held.parts().size(), "part"))
                    .append(also(held.degenerateTriangles(), "degenerate triangle"))
                    .append(held.rig().clips().isEmpty() ? "" : ", animations " + held.clipNames());
        }
        return text.toString();
    }

    private void generate(Generation wanted) throws IOException {
        Ranges.check("--spheres", wanted.count, 1, SceneGenerator.MAX_SPHERES);
        boolean toFile = SceneOutput.check(wanted.output);
        Path day = Home.skyboxes().resolve(ShippedSky.DAY.fileName());
        Scene scene = wanted.sky.over(SceneGenerator.spheres(wanted.count, wanted.seed, day));
        if (toFile) {
            OutputFile.checkKeeps("--output", wanted.output, List.of(scene.sky().file()));
        }
        // As --check does: a scene that no command can draw is not to be written.
        SkyFiles.read(scene.sky().file(), spec.commandLine().getErr());
        SceneOutput.write(scene, wanted.output, spec.commandLine().getOut());
        if (toFile) {
            OutputFile.notes(spec.commandLine(), wanted.output)
                    .println(PrintableText.line(wanted.output + ": " + spheres(scene)));
        }
    }

    private static String also(int count, String what) {
        return count == 0 ? "" : ", " + count + " " + what + (count == 1 ? "" : "s");
    }

    private static String spheres(Scene scene) {
        int count = scene.spheres().size();
        String poured = scene.pour()
                .map(pour -> ", " + pour.count() + (pour.count() == 1 ? " more is poured" : " more are poured"))
                .orElse("");
        return count + (count == 1 ? " sphere" : " spheres") + poured;
    }
}
