package dev.twister.scene;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.JavaConstructor;
import dev.twister.CompiledClasses;
import dev.twister.scene.generate.Pour;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Adding a field to a record must not change its users: they call {@code of}, {@code DEFAULT} and {@code with...}. */
class ConstructorsTest {
    @ParameterizedTest
    @ValueSource(
            classes = {
                Scene.class,
                Camera.class,
                Light.class,
                Ground.class,
                Sphere.class,
                Material.class,
                Rendering.class,
                Physics.class,
                Pour.class
            })
    void onlyTheRecordItselfCallsItsConstructor(Class<?> type) {
        noClasses()
                .that()
                .doNotBelongToAnyOf(type, FullScene.class)
                .should()
                .accessTargetWhere(describe(
                        "is the constructor of " + type.getSimpleName(),
                        access -> access.getTargetOwner().isEquivalentTo(type)
                                && access.getName().equals(JavaConstructor.CONSTRUCTOR_NAME)))
                .check(CompiledClasses.WITH_TESTS);
    }
}
