package dev.twister.files;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Where a system wants what a program keeps for its user. */
public enum UserFolder {
    /** What can be made again. */
    CACHE("LOCALAPPDATA", "Caches", "XDG_CACHE_HOME", ".cache"),
    /** What the user has chosen. */
    SETTINGS("APPDATA", "Application Support", "XDG_CONFIG_HOME", ".config"),
    /** What is to outlive a process, and is nobody's choice. */
    STATE("LOCALAPPDATA", "Application Support", "XDG_STATE_HOME", ".local/state");

    private static final String OWN = "twister";

    private final String windowsVariable;
    private final String macName;
    private final String xdgVariable;
    private final String xdgName;

    UserFolder(String windowsVariable, String macName, String xdgVariable, String xdgName) {
        this.windowsVariable = windowsVariable;
        this.macName = macName;
        this.xdgVariable = xdgVariable;
        this.xdgName = xdgName;
    }

    /** Twister's own folder there, for the user who runs this program; it need not exist yet. */
    public Optional<Path> ofThisUser() {
        return find(System.getProperty("os.name", ""), UserHome.ofThisUser(), System.getenv());
    }

    /**
     * Twister's own folder there, which need not exist yet; empty where the system does not say.
     *
     * @param system as in the property os.name
     * @param home the user's folder
     * @param environment the process's variables
     */
    Optional<Path> find(String system, String home, Map<String, String> environment) {
        String name = system.toLowerCase(Locale.ROOT);
        if (name.startsWith("windows")) {
            return absolute(environment.get(windowsVariable)).map(folder -> folder.resolve(OWN));
        }
        Optional<Path> user = absolute(home);
        if (name.startsWith("mac")) {
            return user.map(folder -> folder.resolve("Library").resolve(macName).resolve(OWN));
        }
        // The XDG specification: a relative path is to be ignored.
        return absolute(environment.get(xdgVariable))
                .or(() -> user.map(folder -> folder.resolve(xdgName)))
                .map(folder -> folder.resolve(OWN));
    }

    private static Optional<Path> absolute(String path) {
        try {
            return Optional.ofNullable(path)
                    .filter(text -> !text.isEmpty())
                    .map(Path::of)
                    .filter(Path::isAbsolute);
        } catch (InvalidPathException _) {
            return Optional.empty();
        }
    }

    /** The user's home folder. */
    static final class UserHome {
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
}
