package dev.twister.engine.vector;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Files that need each other can only be read together, so no more than three of them do. */
final class CyclesTest {
    private static final int MOST_FILES = 3;

    private final Map<String, Set<String>> uses = files(VectorEngine.class.getPackageName());

    @Test
    void noCycleIsOfMoreThanThreeFiles() {
        Set<Set<String>> cycles = uses.keySet().stream()
                .map(this::cycle)
                .filter(files -> files.size() > MOST_FILES)
                .collect(Collectors.toSet());
        assertThat(cycles).isEmpty();
    }

    /** A file, and all that it needs and that need it, by way of others or not. */
    private Set<String> cycle(String file) {
        return reached(file).stream()
                .filter(other -> reached(other).contains(file))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private Set<String> reached(String file) {
        Set<String> reached = new HashSet<>(Set.of(file));
        Deque<String> next = new ArrayDeque<>(reached);
        while (!next.isEmpty()) {
            uses.getOrDefault(next.pop(), Set.of()).stream()
                    .filter(reached::add)
                    .forEach(next::push);
        }
        return reached;
    }

    /** The files of a package and those below, each with what it uses of them. */
    private static Map<String, Set<String>> files(String room) {
        Map<String, Set<String>> files = new TreeMap<>();
        for (JavaClass user : new ClassFileImporter()
                .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                .importPackages(room)) {
            Set<String> used = files.computeIfAbsent(file(user), _ -> new TreeSet<>());
            user.getDirectDependenciesFromSelf().stream()
                    .map(Dependency::getTargetClass)
                    .filter(target -> target.getPackageName().startsWith(room))
                    .map(CyclesTest::file)
                    .forEach(used::add);
        }
        return files;
    }

    private static String file(JavaClass one) {
        return one.getBaseComponentType().getName().replaceFirst("\\$.*", "");
    }
}
