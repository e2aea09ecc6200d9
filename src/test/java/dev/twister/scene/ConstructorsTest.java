package dev.twister.scene;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.belongToAnyOf;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import dev.twister.CompiledClasses;
import dev.twister.scene.generate.Pour;
import java.util.List;
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
        List<JavaClass> callers = CompiledClasses.WITH_TESTS.get(type).getConstructors().stream()
                .flatMap(constructor -> constructor.getAccessesToSelf().stream())
                .map(JavaAccess::getOriginOwner)
                .toList();

        assertThat(callers)
                .isNotEmpty()
                .allMatch(caller -> belongToAnyOf(type, FullScene.class).test(caller)
                        || caller.getName().startsWith(type.getName() + "Copy"));
    }
}
