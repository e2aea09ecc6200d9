package dev.twister.files;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The user's home folder. */
public final class UserHome {
    private UserHome() {}

    /** That of the user who runs this program; empty text where the system does not say. */
    public static String ofThisUser() {
        return find(System.getProperty("os.name", ""), System.getenv(), System.getProperty("user.home", ""));
    }

    /**
     * On Unix the variable HOME wins, as in shells; Java looks at the user's entry in the password file alone.
     *
     * @param system as in the property os.name
     * @param environment the process's variables
     * @param property Java's own answer
     */
    static String find(String system, Map<String, String> environment, String property) {
        if (system.toLowerCase(Locale.ROOT).startsWith("windows")) {
            return property;
        }
        return Optional.ofNullable(environment.get("HOME"))
                .filter(home -> !home.isEmpty())
                .orElse(property);
    }
}
