package dev.twister.engine.vector;

import static com.tngtech.archunit.base.DescribedPredicate.anyElementThat;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noMethods;

import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import org.junit.jupiter.api.Test;

/** A helper that the JVM does not inline makes objects of its vectors, and it is inlined in most JVMs: a rare slow one. */
final class VectorHelpersTest {
    private static final String VECTORS = "jdk.incubator.vector";

    @Test
    void vectorsAreTakenByLanesAlone() {
        check(noMethods()
                .that()
                .areNotDeclaredIn(Lanes.class)
                .should()
                .haveRawParameterTypes(anyElementThat(resideInAPackage(VECTORS))));
    }

    @Test
    void vectorsAreReturnedByLanesAlone() {
        check(noMethods().that().areNotDeclaredIn(Lanes.class).should().haveRawReturnType(resideInAPackage(VECTORS)));
    }

    private static void check(ArchRule rule) {
        rule.check(new ClassFileImporter()
                .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                .importPackagesOf(Lanes.class));
    }
}
