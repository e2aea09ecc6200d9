package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Cycles between the classes of one package: at most {@value #LARGEST} classes depend on each other. */
class ClassCyclesTest {
    private static final int LARGEST = 3;

    @Test
    void cyclesAreSmall() {
        assertThat(cycles()).allSatisfy(cycle -> assertThat(cycle).hasSizeLessThanOrEqualTo(LARGEST));
    }

    private static Set<Set<String>> cycles() {
        Map<String, Set<String>> uses = CompiledClasses.WRITTEN.stream()
                .collect(Collectors.groupingBy(
                        type -> outermost(type).getName(),
                        Collectors.flatMapping(ClassCyclesTest::neighbors, Collectors.toSet())));
        Map<String, Set<String>> reached =
                uses.keySet().stream().collect(Collectors.toMap(name -> name, name -> reachable(name, uses)));
        return reached.keySet().stream()
                .map(name -> reached.get(name).stream()
                        .filter(other -> reached.getOrDefault(other, Set.of()).contains(name))
                        .collect(Collectors.toCollection(TreeSet::new)))
                .filter(Predicate.not(Collection::isEmpty))
                .collect(Collectors.toSet());
    }

    private static Stream<String> neighbors(JavaClass type) {
        return type.getDirectDependenciesFromSelf().stream()
                .map(Dependency::getTargetClass)
                .map(ClassCyclesTest::outermost)
                .filter(other -> CompiledClasses.WRITTEN.contain(other.getName()))
                .filter(other -> other.getPackageName().equals(type.getPackageName()) && !other.equals(outermost(type)))
                .map(JavaClass::getName);
    }

    private static JavaClass outermost(JavaClass type) {
        return type.getEnclosingClass().map(ClassCyclesTest::outermost).orElse(type);
    }

    private static Set<String> reachable(String start, Map<String, Set<String>> uses) {
        Set<String> seen = new TreeSet<>();
        Deque<String> next = new ArrayDeque<>(uses.getOrDefault(start, Set.of()));
        while (!next.isEmpty()) {
            String name = next.pop();
            if (seen.add(name)) {
                next.addAll(uses.getOrDefault(name, Set.of()));
            }
        }
        return seen;
    }
}
