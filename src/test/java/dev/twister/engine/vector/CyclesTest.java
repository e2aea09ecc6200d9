package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.classfile.ClassFile;
import java.lang.classfile.constantpool.Utf8Entry;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;

/** Files in a dependency cycle can only be read together, so a cycle may have at most three. */
final class CyclesTest {
    private static final int MOST_FILES = 3;
    private static final String ROOM = VectorEngine.class.getPackageName().replace('.', '/');

    /** A top-level class of the package as named in class files. */
    private static final Pattern FILE = Pattern.compile(ROOM + "/(?:[a-z]+/)*[A-Z]\\w*");

    @Test
    void noCycleIsOfMoreThanThreeFiles() throws Exception {
        Map<String, Set<String>> reached = new TreeMap<>();
        Map<String, Set<String>> uses = uses();
        uses.keySet().forEach(file -> reached.put(file, reached(file, uses)));
        assertThat(reached).hasSizeGreaterThan(50);
        assertThat(reached.keySet().stream()
                        .map(file -> cycle(file, reached))
                        .filter(files -> files.size() > MOST_FILES)
                        .collect(Collectors.toSet()))
                .isEmpty();
    }

    /** Returns a file's strongly connected component: the files that it depends on and that depend on it. */
    private static Set<String> cycle(String file, Map<String, Set<String>> reached) {
        return reached.get(file).stream()
                .filter(other -> reached.get(other).contains(file))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static Set<String> reached(String file, Map<String, Set<String>> uses) {
        Set<String> reached = new HashSet<>(Set.of(file));
        Deque<String> next = new ArrayDeque<>(reached);
        while (!next.isEmpty()) {
            uses.get(next.pop()).stream().filter(reached::add).forEach(next::push);
        }
        return reached;
    }

    /** Maps each file to the files that it names; the compiler keeps the class names of inlined constants, too. */
    private static Map<String, Set<String>> uses() throws Exception {
        Path classes = Path.of(VectorEngine.class
                .getProtectionDomain()
                .getCodeSource()
                .getLocation()
                .toURI());
        Map<String, Set<String>> uses = new TreeMap<>();
        try (Stream<Path> files = Files.walk(classes.resolve(ROOM))) {
            files.filter(path -> path.toString().endsWith(".class")).forEach(path -> {
                names(classes.relativize(path).toString().replace('\\', '/'))
                        .filter(name -> !name.endsWith("/package-info"))
                        .forEach(user ->
                                uses.computeIfAbsent(user, _ -> new TreeSet<>()).addAll(constants(path)));
            });
        }
        return uses;
    }

    private static Set<String> constants(Path path) {
        try {
            return StreamSupport.stream(
                            ClassFile.of().parse(path).constantPool().spliterator(), false)
                    .filter(Utf8Entry.class::isInstance)
                    .flatMap(entry -> names(((Utf8Entry) entry).stringValue()))
                    .collect(Collectors.toSet());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Stream<String> names(String text) {
        Matcher matcher = FILE.matcher(text);
        return matcher.results().map(result -> result.group());
    }
}
