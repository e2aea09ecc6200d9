package dev.twister;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Who calls the library need not wrap a value in an {@code Optional}. */
class OptionalParametersTest {
    private static final Pattern EXCLUDED =
            Pattern.compile("<packages.without.javadoc>(.*)</packages.without.javadoc>");

    @Test
    void noPublicMethodOfTheDocumentedPackagesTakesAnOptional() throws IOException {
        List<String> excluded = packagesWithoutJavadoc();
        List<JavaMethod> methods = CompiledClasses.WRITTEN.stream()
                .filter(OptionalParametersTest::isPublic)
                .filter(type -> excluded.stream()
                        .noneMatch(name -> type.getPackageName().matches(name)))
                .flatMap(type -> type.getMethods().stream())
                .filter(method -> method.getModifiers().contains(JavaModifier.PUBLIC))
                .toList();

        assertThat(methods).isNotEmpty();
        assertThat(methods.stream()
                        .filter(method -> method.getRawParameterTypes().stream()
                                .anyMatch(parameter -> parameter.isEquivalentTo(Optional.class))))
                .isEmpty();
    }

    private static boolean isPublic(JavaClass type) {
        return type.getModifiers().contains(JavaModifier.PUBLIC)
                && type.getEnclosingClass()
                        .map(OptionalParametersTest::isPublic)
                        .orElse(true);
    }

    private static List<String> packagesWithoutJavadoc() throws IOException {
        String names = EXCLUDED.matcher(Files.readString(Path.of("pom.xml")))
                .results()
                .map(found -> found.group(1))
                .findFirst()
                .orElseThrow();
        return Pattern.compile(":")
                .splitAsStream(names)
                .map(name -> name.replace(".", "\\.").replace("*", ".*"))
                .toList();
    }
}
