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
import dev.twister.kernel.Guides;
import dev.twister.kernel.Instance;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Tone;
import dev.twister.kernel.Variant;
import dev.twister.kernel.Views;
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
    private static final int MOST_FILES = 30;

    /** A subject with rooms that other rooms may use as well. */
    private static final Map<String, List<String>> PARTS = Map.of(
            "scene",
            List.of("scene", "scene.generate", "scene.light", "scene.material", "scene.property", "scene.select"),
            "world",
            List.of("world", "world.animation"),
            "bench",
            List.of("bench", "bench.report"));

    static Stream<Arguments> rooms() {
        return Stream.of(
                room("files"),
                room("scene", "files"),
                room("scene.generate", "scene"),
                room("scene.light", "scene"),
                room("scene.material", "scene"),
                room("scene.property", "scene"),
                room("scene.select", "scene"),
                room("scene.format", "files", "scene", "scene.format.json"),
                room("scene.format.json", "files", "scene"),
                room("exr", "files"),
                room("sky", "files", "exr", "sky.daylight", "sky.image", "sky.radiance"),
                room("sky.webp"),
                room("sky.daylight", "sky"),
                room("sky.image", "files", "sky", "sky.radiance", "sky.webp"),
                room("sky.radiance", "sky", "sky.image"),
                room(
                        "mesh",
                        "files",
                        "scene",
                        "mesh.gltf",
                        "mesh.input",
                        "mesh.obj",
                        "mesh.ply",
                        "mesh.shape",
                        "mesh.stl"),
                room("mesh.input", "files", "mesh", "mesh.assembly"),
                room("mesh.assembly", "scene", "mesh", "mesh.input"),
                room("mesh.meshopt"),
                room("mesh.gltf", "files", "scene", "mesh", "mesh.assembly", "mesh.input", "mesh.meshopt"),
                room("mesh.obj", "files", "scene", "mesh", "mesh.assembly", "mesh.input"),
                room("mesh.ply", "scene", "mesh", "mesh.assembly", "mesh.input"),
                room("mesh.stl", "scene", "mesh", "mesh.assembly", "mesh.input"),
                room("mesh.shape", "scene", "mesh", "mesh.assembly", "mesh.input"),
                room("world.hierarchy", "kernel"),
                room("world.animation", "scene"),
                room("world.table", "scene", "sky", "mesh", "kernel", "world", "world.hierarchy"),
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
                room("bench", "image"),
                room(
                        "bench.benchmark",
                        "bench",
                        "files",
                        "engine",
                        "engine.auto",
                        "image",
                        "world",
                        "scene",
                        "physics"),
                room("bench.report", "bench", "bench.benchmark", "files", "engine", "image", "scene"),
                room("bench.figures", "files", "scene", "scene.format"),
                room("bench.page", "bench", "bench.figures", "files"),
                room(
                        "bench.paper",
                        "bench",
                        "bench.benchmark",
                        "bench.figures",
                        "bench.page",
                        "files",
                        "engine",
                        "image"),
                room("bench.device", "bench", "bench.benchmark", "bench.paper", "engine", "image", "world", "scene"),
                room("bench.results", "bench", "bench.page", "bench.paper", "files", "image"),
                room("gui.controls", "mesh", "scene", "sky", "scene.property"),
                room(
                        "gui.edit",
                        "mesh",
                        "scene",
                        "kernel",
                        "world",
                        "physics",
                        "scene.generate",
                        "scene.light",
                        "scene.property",
                        "scene.select"),
                room("gui.picking", "scene", "kernel", "world", "gui.edit", "scene.light", "scene.property"),
                room(
                        "gui.property",
                        "scene",
                        "sky",
                        "kernel",
                        "world",
                        "image",
                        "gui.edit",
                        "scene.light",
                        "scene.property"),
                room(
                        "gui.drawing",
                        "mesh",
                        "scene",
                        "scene.format",
                        "sky",
                        "kernel",
                        "world",
                        "physics",
                        "denoise",
                        "engine",
                        "engine.auto",
                        "image",
                        "gui.edit",
                        "gui.picking",
                        "gui.property",
                        "scene.generate",
                        "scene.property"),
                room(
                        "gui.studio",
                        "mesh",
                        "scene",
                        "scene.format",
                        "world",
                        "physics",
                        "denoise",
                        "engine",
                        "engine.auto",
                        "image",
                        "gui.controls",
                        "gui.edit",
                        "gui.property",
                        "gui.drawing",
                        "scene.light",
                        "scene.property",
                        "scene.select",
                        "world.animation"),
                room(
                        "gui.files",
                        "engine",
                        "files",
                        "image",
                        "mesh",
                        "scene",
                        "scene.format",
                        "sky",
                        "world",
                        "render",
                        "engine.auto",
                        "gui.controls",
                        "gui.edit",
                        "gui.picking",
                        "gui.property",
                        "gui.drawing",
                        "gui.studio",
                        "scene.light",
                        "scene.property",
                        "scene.select"),
                room(
                        "gui.picture",
                        "scene",
                        "kernel",
                        "world",
                        "engine",
                        "explain",
                        "image",
                        "bench",
                        "threads",
                        "gui.controls",
                        "gui.edit",
                        "gui.picking",
                        "gui.property",
                        "gui.drawing",
                        "gui.studio",
                        "gui.files"),
                room(
                        "gui.bodies",
                        "scene",
                        "kernel",
                        "world",
                        "image",
                        "gui.controls",
                        "gui.edit",
                        "gui.picking",
                        "gui.property",
                        "gui.drawing",
                        "gui.studio",
                        "gui.picture",
                        "scene.light",
                        "scene.property",
                        "scene.select"),
                room(
                        "gui.camera",
                        "scene",
                        "world",
                        "image",
                        "gui.controls",
                        "gui.edit",
                        "gui.picking",
                        "gui.property",
                        "gui.drawing",
                        "gui.studio",
                        "gui.picture",
                        "scene.property",
                        "world.animation"),
                room(
                        "gui.panel",
                        "scene",
                        "scene.format",
                        "world",
                        "denoise",
                        "engine",
                        "gui.controls",
                        "gui.edit",
                        "gui.property",
                        "gui.drawing",
                        "gui.studio",
                        "gui.files",
                        "gui.picture",
                        "scene.light",
                        "scene.property",
                        "scene.select",
                        "world.animation"),
                room(
                        "gui.rendering",
                        "scene",
                        "world",
                        "film",
                        "denoise",
                        "render",
                        "engine",
                        "engine.auto",
                        "image",
                        "gui.controls",
                        "gui.drawing",
                        "gui.studio",
                        "gui.files",
                        "scene.property",
                        "scene.select"),
                room(
                        "gui.viewer",
                        "scene",
                        "sky",
                        "world",
                        "denoise",
                        "render",
                        "image",
                        "gui.controls",
                        "gui.property",
                        "gui.drawing",
                        "gui.studio",
                        "gui.files",
                        "gui.picture"),
                room(
                        "gui",
                        "files",
                        "scene",
                        "world",
                        "engine",
                        "engine.auto",
                        "bench",
                        "bench.report",
                        "scene.select",
                        "world.animation",
                        "gui.."),
                room("cli", "files", "bench.benchmark", "mesh", "render", "scene", "sky", "engine", "cli.."),
                room("cli.manual"),
                room(
                        "cli.file",
                        "files",
                        "mesh",
                        "scene",
                        "scene.format",
                        "sky",
                        "world",
                        "render",
                        "image",
                        "bench",
                        "bench.benchmark",
                        "film",
                        "gui",
                        "gui.studio"),
                room(
                        "cli.option",
                        "files",
                        "mesh",
                        "scene",
                        "sky",
                        "world",
                        "film",
                        "denoise",
                        "motion",
                        "render",
                        "engine",
                        "engine.auto",
                        "image",
                        "bench.benchmark",
                        "cli.file"),
                room(
                        "cli.progress",
                        "files",
                        "render",
                        "denoise",
                        "bench",
                        "bench.benchmark",
                        "engine",
                        "image",
                        "cli.file",
                        "cli.option"),
                room(
                        "cli.command",
                        "files",
                        "mesh",
                        "scene",
                        "scene.format",
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
                        "bench.benchmark",
                        "bench.device",
                        "bench.figures",
                        "bench.page",
                        "bench.paper",
                        "bench.results",
                        "gui",
                        "gui.files",
                        "gui.studio",
                        "cli.file",
                        "cli.manual",
                        "cli.option",
                        "cli.progress"));
    }

    private static Arguments room(String room, String... neighbors) {
        return Arguments.of(room, neighbors);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("rooms")
    void roomLeansOnItsNeighborsOnly(String room, String[] neighbors) {
        String[] allowed = Stream.concat(Stream.of(room), Arrays.stream(neighbors))
                .flatMap(name -> PARTS.getOrDefault(name, List.of(name)).stream())
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
                        "dev.twister.world..", "dev.twister.scene..", "dev.twister.sky", "dev.twister.mesh"))
                .or(belongToAnyOf(Views.class, Guides.class, Instance.class, Layout.class, Tone.class, Variant.class));
        classes()
                .that()
                .resideInAPackage("dev.twister.world..")
                .should()
                .onlyDependOnClassesThat(allowed)
                .check(TWISTER);
    }

    @Test
    void physicsKnowsTheKernelsLayoutOnly() {
        DescribedPredicate<JavaClass> allowed = resideOutsideOfPackage("dev.twister..")
                .or(resideInAnyPackage(
                        "dev.twister.physics",
                        "dev.twister.scene..",
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
    void foldersAreSmall() {
        Map<String, Long> files = TWISTER.stream()
                .filter(JavaClass::isTopLevelClass)
                // RecordBuilder writes these.
                .filter(type -> !type.getSimpleName().endsWith("Copy"))
                .filter(type -> !type.getPackageName().equals("dev.twister.kernel"))
                .collect(Collectors.groupingBy(JavaClass::getPackageName, Collectors.counting()));
        assertThat(files).allSatisfy((room, count) -> assertThat(count).isLessThanOrEqualTo(MOST_FILES));
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
