package dev.twister.site;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Checks that links lead somewhere; files of the project that pages link to, such as pictures, come to the site. */
final class Links {
    private static final Pattern LINK = Pattern.compile("(?:href|src)=\"(?![a-z]+:)([^\"#]*)(?:#([^\"]*))?\"");

    private final Path site;
    private final List<String> problems = new ArrayList<>();
    private int count;

    Links(Path site) {
        this.site = site;
    }

    /** What is wrong, one line per link. */
    List<String> problems() {
        return problems;
    }

    int count() {
        return count;
    }

    void check(Page page) {
        LINK.matcher(page.html()).results().forEach(link -> {
            count++;
            Path place = link.group(1).isEmpty()
                    ? page.address()
                    : page.address().resolveSibling(link.group(1)).normalize();
            try {
                check(page, place, link.group(2));
            } catch (IOException problem) {
                throw new UncheckedIOException(problem);
            }
        });
    }

    private void check(Page page, Path place, String anchor) throws IOException {
        Path file = site.resolve(place);
        boolean outside = place.startsWith("..");
        if (!outside && Files.notExists(file) && Files.isRegularFile(place)) {
            Files.createDirectories(file.getParent());
            Files.copy(place, file, StandardCopyOption.REPLACE_EXISTING);
        }
        if (!outside && Files.isDirectory(place) && Files.notExists(file.resolve("index.html"))) {
            list(place, file);
        }
        if (outside || Files.notExists(file)) {
            problems.add(page.source() + ": there is no " + place);
        } else if (anchor != null && !Files.readString(file).contains("id=\"" + anchor + "\"")) {
            problems.add(page.source() + ": " + place + " has no heading #" + anchor);
        }
    }

    /** A folder of the project as a list of its files. */
    private static void list(Path folder, Path target) throws IOException {
        List<Path> files;
        try (Stream<Path> found = Files.walk(folder)) {
            files = found.filter(Files::isRegularFile)
                    .filter(file -> !folder.relativize(file).startsWith("target"))
                    .sorted()
                    .toList();
        }
        for (Path file : files) {
            Path copy = target.resolve(folder.relativize(file).toString());
            Files.createDirectories(copy.getParent());
            Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
        }
        Files.createDirectories(target);
        Files.writeString(
                target.resolve("index.html"),
                files.stream()
                        .map(file -> Html.escaped(folder.relativize(file).toString().replace('\\', '/')))
                        .map(name -> "<li><a href=\"" + name + "\">" + name + "</a></li>\n")
                        .collect(Collectors.joining(
                                "", "<!DOCTYPE html>\n<title>" + folder + "</title>\n<ul>\n", "</ul>\n")));
    }
}
