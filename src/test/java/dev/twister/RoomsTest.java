package dev.twister;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.belongToAnyOf;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.GeneralCodingRules.ACCESS_STANDARD_STREAMS;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import dev.twister.kernel.Aspect;
import dev.twister.kernel.Guides;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.kernel.Variant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The design's table of packages and their allowed dependencies. */
class RoomsTest {
    private static final JavaClasses TWISTER = CompiledClasses.PROGRAM;

    static Stream<Arguments> rooms() {
        return Stream.of(
                room("files"),
                room("scene", "files"),
                room("scene.format", "files", "scene"),
                room("exr", "files"),
                room("sky", "files", "exr", "sky.webp"),
                room("sky.webp"),
                room("mesh", "files", "scene"),
                room("image", "files", "exr"),
                room("threads"),
                room("denoise"),
                room("film", "files", "threads"),
                room("motion", "files", "scene", "kernel", "world"),
                room("engine", "kernel", "world", "image"),
                room(
                        "render",
                        "files",
                        "scene",
                        "scene.format",
                        "world",
                        "physics",
                        "motion",
                        "film",
                        "denoise",
                        "engine",
                        "image",
                        "threads"),
                room("engine.tornado", "kernel", "world", "image", "engine"),
                room("engine.vector.lanes", "kernel", "engine"),
                room("engine.vector.frame", "kernel", "world", "image", "engine.vector.lanes"),
                room("engine.vector.step", "kernel", "world", "image", "engine.vector.lanes", "engine.vector.frame"),
                room("engine.vector.crowd", "kernel", "engine.vector.lanes", "engine.vector.frame"),
                room(
                        "engine.vector.shortcut",
                        "kernel",
                        "world",
                        "engine.vector.lanes",
                        "engine.vector.frame",
                        "engine.vector.step"),
                room(
                        "engine.vector.shadow",
                        "kernel",
                        "world",
                        "engine.vector.lanes",
                        "engine.vector.frame",
                        "engine.vector.crowd",
                        "engine.vector.shortcut"),
                room(
                        "engine.vector.mesh",
                        "kernel",
                        "world",
                        "engine.vector.lanes",
                        "engine.vector.frame",
                        "engine.vector.shadow"),
                room("engine.vector.made", "kernel", "world", "engine.vector.lanes"),
                room("engine.vector", "kernel", "world", "image", "engine", "threads", "engine.vector.."),
                room("engine.auto", "files", "world", "image", "engine"),
                room("explain", "kernel", "scene", "world", "image", "engine"),
                room("bench", "files", "engine", "engine.auto", "image", "world", "scene", "scene.format", "physics"),
                room(
                        "gui.model",
                        "files",
                        "denoise",
                        "mesh",
                        "scene",
                        "scene.format",
                        "sky",
                        "kernel",
                        "world",
                        "physics",
                        "threads",
                        "render",
                        "engine",
                        "engine.auto",
                        "explain",
                        "image",
                        "explain"),
                room(
                        "gui.drawing",
                        "mesh",
                        "denoise",
                        "scene",
                        "scene.format",
                        "sky",
                        "world",
                        "physics",
                        "engine",
                        "engine.auto",
                        "explain",
                        "image",
                        "gui.model"),
                room("gui.controls", "scene", "sky", "mesh"),
                room(
                        "gui.studio",
                        "mesh",
                        "denoise",
                        "scene",
                        "scene.format",
                        "world",
                        "physics",
                        "engine",
                        "engine.auto",
                        "image",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model"),
                room(
                        "gui.files",
                        "files",
                        "mesh",
                        "scene",
                        "scene.format",
                        "sky",
                        "world",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model",
                        "gui.studio"),
                room(
                        "gui.gallery",
                        "files",
                        "scene",
                        "scene.format",
                        "world",
                        "engine",
                        "image",
                        "gui.controls",
                        "gui.files",
                        "gui.model",
                        "gui.studio"),
                room(
                        "gui.picture",
                        "scene",
                        "world",
                        "engine",
                        "explain",
                        "image",
                        "bench",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model",
                        "gui.studio",
                        "gui.files"),
                room(
                        "gui.bodies",
                        "scene",
                        "world",
                        "image",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model",
                        "gui.studio",
                        "gui.picture"),
                room(
                        "gui.camera",
                        "scene",
                        "world",
                        "image",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model",
                        "gui.studio",
                        "gui.picture"),
                room(
                        "gui.panel",
                        "scene",
                        "denoise",
                        "scene.format",
                        "world",
                        "engine",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model",
                        "gui.studio",
                        "gui.files",
                        "gui.picture"),
                room(
                        "gui.rendering",
                        "scene",
                        "world",
                        "film",
                        "denoise",
                        "engine",
                        "engine.auto",
                        "image",
                        "render",
                        "gui.controls",
                        "gui.drawing",
                        "gui.model",
                        "gui.studio",
                        "gui.files"),
                room("gui", "files", "scene", "world", "engine", "engine.auto", "bench", "gui.."),
                room(
                        "cli",
                        "files",
                        "mesh",
                        "scene",
                        "scene.format",
                        "mesh",
                        "sky",
                        "world",
                        "physics",
                        "motion",
                        "film",
                        "denoise",
                        "render",
                        "engine",
                        "engine.auto",
                        "explain",
                        "image",
                        "bench",
                        "gui",
                        "gui.files",
                        "gui.studio"));
    }

    private static Arguments room(String room, String... neighbors) {
        return Arguments.of(room, neighbors);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("rooms")
    void roomLeansOnItsNeighborsOnly(String room, String[] neighbors) {
        String[] allowed = Stream.concat(Stream.of(room), Arrays.stream(neighbors))
                .map(name -> "dev.twister." + name)
                .toArray(String[]::new);
        classes()
                .that(resideInAPackage("dev.twister." + room))
                .should()
                .onlyDependOnClassesThat(resideOutsideOfPackage("dev.twister..").or(resideInAnyPackage(allowed)))
                .allowEmptyShould(true)
                .check(TWISTER);
    }

    @Test
    void kernelLeansOnTheLanguageOnly() {
        classes()
                .that()
                .resideInAPackage("dev.twister.kernel")
                .should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage("dev.twister.kernel", "java.lang")
                .check(TWISTER);
    }

    @Test
    void worldKnowsTheKernelsNumbersOnly() {
        DescribedPredicate<JavaClass> allowed = resideOutsideOfPackage("dev.twister..")
                .or(resideInAnyPackage(
                        "dev.twister.world", "dev.twister.scene..", "dev.twister.sky", "dev.twister.mesh"))
                .or(belongToAnyOf(Aspect.class, Guides.class, Instance.class, Layout.class, Tone.class, Variant.class));
        classes()
                .that()
                .resideInAPackage("dev.twister.world")
                .should()
                .onlyDependOnClassesThat(allowed)
                .check(TWISTER);
    }

    @Test
    void physicsKnowsTheKernelsLayoutOnly() {
        DescribedPredicate<JavaClass> allowed = resideOutsideOfPackage("dev.twister..")
                .or(resideInAnyPackage(
                        "dev.twister.physics",
                        "dev.twister.scene",
                        "dev.twister.mesh",
                        "dev.twister.world",
                        "dev.twister.threads"))
                .or(belongToAnyOf(Layout.class));
        classes()
                .that()
                .resideInAPackage("dev.twister.physics")
                .should()
                .onlyDependOnClassesThat(allowed)
                .check(TWISTER);
    }

    @Test
    void libraryKnowsNothingOfCommandsAndTheWindow() {
        DescribedPredicate<JavaClass> allowed = resideOutsideOfPackage("dev.twister..")
                .or(resideInAnyPackage(
                        "dev.twister",
                        "dev.twister.scene..",
                        "dev.twister.sky",
                        "dev.twister.mesh",
                        "dev.twister.world",
                        "dev.twister.image",
                        "dev.twister.engine"));
        classes()
                .that()
                .resideInAPackage("dev.twister")
                .should()
                .onlyDependOnClassesThat(allowed)
                .check(TWISTER);
    }

    @Test
    void everyPackageIsARoom() {
        Stream<String> known =
                Stream.concat(rooms().map(room -> room.get()[0].toString()), Stream.of("kernel", "world", "physics"));
        assertThat(TWISTER.stream().map(JavaClass::getPackageName).distinct())
                .isSubsetOf(Stream.concat(Stream.of("dev.twister"), known.map(name -> "dev.twister." + name))
                        .toList());
    }

    @Test
    void noSimpleNameStandsTwice() {
        Map<String, List<String>> classesByName = TWISTER.stream()
                .filter(found ->
                        found.isTopLevelClass() && !found.getSimpleName().equals("package-info"))
                .collect(Collectors.groupingBy(
                        JavaClass::getSimpleName, Collectors.mapping(JavaClass::getName, Collectors.toList())));
        assertThat(classesByName.values()).filteredOn(names -> names.size() > 1).isEmpty();
    }

    @Test
    void roomsHaveNoCycles() {
        slices().matching("dev.twister.(*)..").should().beFreeOfCycles().check(TWISTER);
        slices().matching("dev.twister.gui.(*)").should().beFreeOfCycles().check(TWISTER);
    }

    @Test
    void nothingStaticChanges() {
        fields().that().areStatic().should().beFinal().check(TWISTER);
    }

    @Test
    void onlyCommandsSpeak() {
        noClasses()
                .that()
                .resideOutsideOfPackage("dev.twister.cli..")
                .should(ACCESS_STANDARD_STREAMS)
                .check(TWISTER);
    }
}
