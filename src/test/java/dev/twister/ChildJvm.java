package dev.twister;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Another JVM with the classes of the tests, started without any option of this one's. */
public final class ChildJvm {
    private static final long MOST_SECONDS = 300;

    private ChildJvm() {}

    /** Starts one that is ended after some minutes, so that a test that reads its output or waits for it goes on. */
    public static Process start(ProcessBuilder builder) throws IOException {
        Process java = builder.start();
        java.onExit().orTimeout(MOST_SECONDS, TimeUnit.SECONDS).exceptionally(_ -> java.destroyForcibly());
        return java;
    }

    /** One that is to run a class's main method without any option: without the Vector API, too. */
    public static ProcessBuilder of(Class<?> main, String... arguments) {
        return of(List.of(), main, arguments);
    }

    /** The same with the launcher's options, as a user's, and some more. */
    public static ProcessBuilder asLaunched(List<String> moreOptions, Class<?> main, String... arguments) {
        List<String> options = new ArrayList<>();
        for (String file : List.of("jvm.options", "engine.options", "collector.options")) {
            options.add("@" + Path.of("scripts", file));
        }
        options.addAll(moreOptions);
        return of(options, main, arguments);
    }

    private static ProcessBuilder of(List<String> options, Class<?> main, String... arguments) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(options);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }
}
