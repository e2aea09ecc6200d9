package dev.twister.engine.vector.lanes;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import dev.twister.engine.vector.shortcut.SkyRows;
import dev.twister.engine.vector.shortcut.SkyWindow;
import org.junit.jupiter.api.Test;

final class FusedMultiplyAddTest {
    /**
     * On a CPU without fused multiply-add, one forgotten check would be a thousand times slower, and no other test
     * covers it.
     */
    @Test
    void isAskedForInOnePlaceOnly() {
        noClasses()
                .that()
                .doNotBelongToAnyOf(Lanes.class, SkyRows.class, SkyWindow.class)
                .should()
                .callMethodWhere(target(name("fma"))
                        .and(target(owner(DescribedPredicate.not(name(Lanes.class.getName()))))))
                .check(new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        .importPackagesOf(Lanes.class));
    }
}
