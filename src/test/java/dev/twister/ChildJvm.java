package dev.twister;

import java.nio.file.Path;
import java.util.stream.Stream;

/** Another JVM with the classes of the tests, started without any option of this one's: without the Vector API, too. */
public final class ChildJvm {
    private ChildJvm() {}

    /** One that is to run a class's main method. */
    public static ProcessBuilder of(Class<?> main, String... arguments) {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        return new ProcessBuilder(Stream.concat(
                        Stream.of(java, "-cp", System.getProperty("java.class.path"), main.getName()),
                        Stream.of(arguments))
                .toList());
    }
}
