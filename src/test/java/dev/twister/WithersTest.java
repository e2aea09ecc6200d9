package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** A wither of one value has the name of the component that it changes. */
class WithersTest {
    private static final List<Class<?>> RECORDS = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS).importPackages("dev.twister.scene").stream()
                    .filter(JavaClass::isRecord)
                    .<Class<?>>map(JavaClass::reflect)
                    .toList();

    @Test
    void everyWitherOfOneValueIsNamedAsItsComponent() {
        assertThat(RECORDS).isNotEmpty();
        assertThat(RECORDS.stream().flatMap(WithersTest::withers).filter(wither -> !isComponent(wither)))
                .isEmpty();
    }

    private static Stream<Method> withers(Class<?> type) {
        return Arrays.stream(type.getDeclaredMethods())
                .filter(method -> method.getName().matches("with[A-Z].*"))
                .filter(method -> !Modifier.isStatic(method.getModifiers()) && !method.isBridge())
                .filter(method -> method.getParameterCount() == 1);
    }

    /** Of the record itself, or of a record that it holds, such as the color of a sphere's material. */
    private static boolean isComponent(Method wither) {
        String name = wither.getName().substring("with".length());
        String component = name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1);
        return Stream.concat(Stream.of(wither.getDeclaringClass()), held(wither.getDeclaringClass()))
                .flatMap(type -> Arrays.stream(type.getRecordComponents()))
                .map(RecordComponent::getName)
                .anyMatch(component::equals);
    }

    private static Stream<Class<?>> held(Class<?> type) {
        return Arrays.stream(type.getRecordComponents())
                .<Class<?>>map(RecordComponent::getType)
                .filter(Class::isRecord);
    }
}
