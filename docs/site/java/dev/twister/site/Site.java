package dev.twister.site;

import dev.twister.bench.results.ResultsPage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** Makes the documentation site: {@code ./mvnw -Psite}. */
public final class Site {
    private static final Path SOURCES = Path.of("docs", "site");

    private Site() {}

    /** Takes the folder to write; a broken link is an error. */
    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        Files.createDirectories(folder.resolve("benchmarks"));
        ResultsPage.write(folder.resolve("benchmarks"), List.of(Path.of("benchmarks", "results.jsonl")));
        List<Page> pages = pages();
        Navigation navigation = new Navigation(pages);
        for (Page page : pages) {
            Path file = folder.resolve(page.address());
            Files.createDirectories(file.getParent());
            Files.writeString(file, navigation.around(page));
        }
        for (String name : List.of("site.css", "search.js")) {
            Files.copy(SOURCES.resolve(name), folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
        }
        Files.writeString(folder.resolve("pages.js"), SearchIndex.of(pages));
        Links links = new Links(folder);
        pages.forEach(links::check);
        links.problems().forEach(System.err::println);
        System.out.println(folder.resolve("index.html") + ": " + pages.size() + " pages, " + links.count() + " links");
        if (!links.problems().isEmpty()) {
            System.exit(1);
        }
    }

    private static List<Page> pages() throws IOException {
        List<Path> files = new ArrayList<>();
        Stream.of("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md")
                .map(Path::of)
                .forEach(files::add);
        try (Stream<Path> found = Files.walk(Path.of("docs"))) {
            found.filter(file -> file.toString().endsWith(".md"))
                    .sorted(Comparator.comparing(Path::getParent)
                            .thenComparingInt(Site::number)
                            .thenComparing(Comparator.naturalOrder()))
                    .forEach(files::add);
        }
        List<Page> pages = new ArrayList<>();
        for (Path file : files) {
            pages.add(Page.read(file));
        }
        return pages;
    }

    /** The number that a file's name begins with, as lessons and decisions do; 0 for others. */
    private static int number(Path file) {
        String digits = file.getFileName().toString().replaceFirst("\\D.*", "");
        return digits.isEmpty() ? 0 : Integer.parseInt(digits);
    }
}
