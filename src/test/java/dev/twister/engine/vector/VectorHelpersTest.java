package dev.twister.engine.vector;

import static com.tngtech.archunit.base.DescribedPredicate.anyElementThat;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaAccess.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.type;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameStartingWith;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noMethods;

import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import dev.twister.engine.vector.lanes.Lanes;
import jdk.incubator.vector.ShortVector;
import org.junit.jupiter.api.Test;

/**
 * A helper that is not inlined boxes its vectors. The JVM inlines it in most runs, so a failure would be a rare slow
 * JVM.
 */
final class VectorHelpersTest {
    private static final String VECTORS = "jdk.incubator.vector";

    /** {@link StageInlining#ALWAYS}. */
    private static final String ALWAYS_INLINED = Lanes.class.getPackageName();

    @Test
    void vectorsAreTakenByLanesAlone() {
        check(noMethods()
                .that()
                .areDeclaredInClassesThat(resideOutsideOfPackage(ALWAYS_INLINED))
                .should()
                .haveRawParameterTypes(anyElementThat(resideInAPackage(VECTORS))));
    }

    @Test
    void vectorsAreReturnedByLanesAlone() {
        check(noMethods()
                .that()
                .areDeclaredInClassesThat(resideOutsideOfPackage(ALWAYS_INLINED))
                .should()
                .haveRawReturnType(resideInAPackage(VECTORS)));
    }

    /**
     * The JVM profiles which vector classes each Vector API method has seen; with more than one it may box. Shorts are
     * unpacked in one place and have a width of their own.
     */
    @Test
    void vectorsHaveThePacketsWidth() {
        check(noClasses()
                .that()
                .doNotBelongToAnyOf(Lanes.class)
                .should()
                .accessFieldWhere(target(owner(resideInAPackage(VECTORS)))
                        .and(target(owner(not(type(ShortVector.class)))))
                        .and(target(nameStartingWith("SPECIES_"))))
                .orShould()
                .callMethodWhere(target(name("withShape")).or(target(name("withLanes")))));
    }

    private static void check(ArchRule rule) {
        rule.check(new ClassFileImporter()
                .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                .importPackagesOf(VectorEngine.class));
    }
}
