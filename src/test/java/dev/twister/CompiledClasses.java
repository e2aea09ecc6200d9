package dev.twister;

import static com.tngtech.archunit.base.DescribedPredicate.describe;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;

/** The compiled classes, read once for all tests of a JVM: that takes seconds. */
public final class CompiledClasses {
    public static final JavaClasses WITH_TESTS = new ClassFileImporter().importPackages("dev.twister");

    static final JavaClasses PROGRAM =
            WITH_TESTS.that(describe("are of the program", (JavaClass type) -> isOfTheProgram(type)));

    /** Without the copying of records, which RecordBuilder writes. */
    static final JavaClasses WRITTEN = PROGRAM.that(
            describe("are written by hand", (JavaClass type) -> !type.getName().matches(".*Copy(\\$.*)?")));

    private CompiledClasses() {}

    private static boolean isOfTheProgram(JavaClass type) {
        return type.getSource()
                .filter(source -> ImportOption.Predefined.DO_NOT_INCLUDE_TESTS.includes(Location.of(source.getUri())))
                .isPresent();
    }
}
