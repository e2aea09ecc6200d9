package dev.twister.denoise;

import java.io.File;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Where the library Open Image Denoise may be.
 *
 * @param environment variables of the process
 * @param home the user's home folder
 * @param system name of the operating system, as in the property {@code os.name}
 */
record LibraryPlaces(Map<String, String> environment, Path home, String system) {
    /** The variable that names the library or a folder with it. */
    static final String VARIABLE = "TWISTER_OIDN";

    private static final List<String> SUBFOLDERS = List.of("", "lib", "bin");

    /** Folders of Homebrew, of MacPorts and of packages for Linux that the loader does not search by itself. */
    private static final List<String> USUAL_FOLDERS =
            List.of("/opt/homebrew/lib", "/usr/local/lib", "/opt/local/lib", "/usr/lib64");

    /** The places of this machine. */
    static LibraryPlaces ofThisMachine() {
        return new LibraryPlaces(
                System.getenv(), Path.of(System.getProperty("user.home")), System.getProperty("os.name"));
    }

    /** What the variable names; empty if it is not set. */
    Optional<String> named() {
        return Optional.ofNullable(environment.get(VARIABLE)).filter(text -> !text.isBlank());
    }

    /** The library's files: where the variable points to, or everywhere else, in the order of preference. */
    List<Path> files() {
        return named().map(text -> in(text, SUBFOLDERS).toList())
                .orElseGet(() -> Stream.of(besidePackage(), onLibraryPath(), fromPip())
                        .flatMap(files -> files)
                        .distinct()
                        .toList());
    }

    /** Names by which the system's own loader may find the library; of Windows none, as it looks beside scenes too. */
    List<String> names() {
        return isWindows() ? List.of() : fileNames();
    }

    private List<String> fileNames() {
        if (isWindows()) {
            return List.of("OpenImageDenoise.dll");
        }
        return isMac()
                ? List.of("libOpenImageDenoise.2.dylib", "libOpenImageDenoise.dylib")
                : List.of("libOpenImageDenoise.so.2", "libOpenImageDenoise.so");
    }

    private Stream<Path> besidePackage() {
        return folders("TWISTER_HOME").flatMap(folder -> in(folder + File.separator + "oidn", SUBFOLDERS));
    }

    private Stream<Path> onLibraryPath() {
        String variable = isWindows() ? "PATH" : isMac() ? "DYLD_LIBRARY_PATH" : "LD_LIBRARY_PATH";
        Stream<String> usual = isWindows() ? Stream.empty() : USUAL_FOLDERS.stream();
        return Stream.concat(folders(variable), usual).flatMap(folder -> in(folder, List.of("")));
    }

    /** Where {@code pip install pyoidn} puts the library: in a virtual environment, Conda's, the user's or Python's. */
    private Stream<Path> fromPip() {
        List<Path> roots = new ArrayList<>();
        Stream.of("VIRTUAL_ENV", "CONDA_PREFIX").flatMap(this::folders).forEach(folder -> add(roots, folder));
        roots.add(home.resolve(".local"));
        folders("PATH").forEach(folder -> add(roots, folder + File.separator + ".."));
        List<Path> packages = new ArrayList<>();
        for (Path root : roots) {
            packages.add(root.resolve(Path.of("Lib", "site-packages")));
            for (Path python : pythons(root.resolve("lib"))) {
                packages.add(python.resolve("site-packages"));
                packages.add(python.resolve("dist-packages"));
            }
        }
        return packages.stream()
                .flatMap(folder -> in(folder.resolve(Path.of("pyoidn", "oidn")).toString(), List.of("lib", "bin")));
    }

    private static void add(List<Path> roots, String folder) {
        try {
            roots.add(Path.of(folder).normalize());
        } catch (InvalidPathException _) {
            // A variable may hold anything.
        }
    }

    /** Folders such as {@code python3.12}, the newest first. */
    private static List<Path> pythons(Path folder) {
        List<Path> found = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (DirectoryStream<Path> versions = Files.newDirectoryStream(folder, "python3*")) {
                versions.forEach(found::add);
            } catch (IOException _) {
                return List.of();
            }
        }
        found.sort(Comparator.comparingInt((Path path) -> path.toString().length())
                .thenComparing(Comparator.naturalOrder())
                .reversed());
        return found;
    }

    private Stream<String> folders(String variable) {
        return Stream.ofNullable(environment.get(variable))
                .flatMap(text -> Stream.of(text.split(Pattern.quote(File.pathSeparator))))
                .filter(LibraryPlaces::isAbsolute);
    }

    /** A place that depends on the current folder may be beside a scene of someone else. */
    private static boolean isAbsolute(String folder) {
        try {
            return Path.of(folder).isAbsolute();
        } catch (InvalidPathException _) {
            return false;
        }
    }

    /** The file itself, or the library in the folder or its subfolders. */
    private Stream<Path> in(String place, List<String> subfolders) {
        try {
            Path path = Path.of(place).toAbsolutePath().normalize();
            return Files.isRegularFile(path)
                    ? Stream.of(path)
                    : subfolders.stream()
                            .flatMap(sub -> fileNames().stream().map(path.resolve(sub)::resolve))
                            .filter(Files::isRegularFile)
                            .limit(1);
        } catch (InvalidPathException _) {
            return Stream.empty();
        }
    }

    private boolean isWindows() {
        return system.startsWith("Windows");
    }

    private boolean isMac() {
        return system.startsWith("Mac");
    }
}
