import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the check of an exercise expects, and what it finds instead. */
final class Checks {
    private final List<String> problems = new ArrayList<>();

    /** Whether the solution is to be checked instead of the attempt. */
    static boolean isSolution(String... arguments) {
        return arguments.length > 0 && arguments[0].equals("solution");
    }

    void near(String what, double actual, double expected, double tolerance) {
        if (!(Math.abs(actual - expected) <= tolerance)) {
            problems.add(String.format(Locale.ROOT, "%s is %.4f, but must be %.4f", what, actual, expected));
        }
    }

    void that(boolean holds, String problem) {
        if (!holds) {
            problems.add(problem);
        }
    }

    /** Prints what was found; 0 if all is as expected, else 1. */
    int report(String picture) {
        problems.forEach(problem -> System.out.println("not yet: " + problem));
        System.out.println((problems.isEmpty() ? "done" : "your result so far") + ": " + picture);
        return problems.isEmpty() ? 0 : 1;
    }
}
