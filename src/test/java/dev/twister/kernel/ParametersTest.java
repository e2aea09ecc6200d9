package dev.twister.kernel;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;

import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import org.junit.jupiter.api.Test;

/** Arrays and values are arguments in groups, which leaves room below TornadoVM's limit of 20. */
class ParametersTest {
    private static final int MOST = 10;

    @Test
    void noMethodOfTheKernelHasMoreThanTenParameters() {
        methods()
                .should(new ArchCondition<JavaMethod>("have at most " + MOST + " parameters") {
                    @Override
                    public void check(JavaMethod method, ConditionEvents events) {
                        int count = method.getRawParameterTypes().size();
                        events.add(new SimpleConditionEvent(
                                method, count <= MOST, method.getFullName() + " has " + count + " parameters"));
                    }
                })
                .check(new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        .importPackages("dev.twister.kernel"));
    }
}
