package dev.twister.site;

import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** What stands around each page: the list of all, and the search. */
final class Navigation {
    private static final String DECISIONS = "docs/decisions/";
    private static final String LESSONS = "docs/lessons/";

    private final List<Page> pages;

    Navigation(List<Page> pages) {
        this.pages = pages;
    }

    /** The whole HTML of a page. */
    String around(Page page) {
        return """
                <!DOCTYPE html>
                <html lang="en">
                <head>
                <meta charset="utf-8">
                <meta name="viewport" content="width=device-width, initial-scale=1">
                <title>%1$s - Twister</title>
                <link rel="stylesheet" href="%2$ssite.css">
                </head>
                <body data-root="%2$s">
                <nav>
                <input type="search" id="search" placeholder="Search" aria-label="Search">
                <ol id="found"></ol>
                %3$s</nav>
                <main>
                %4$s</main>
                <script src="%2$spages.js"></script>
                <script src="%2$ssearch.js"></script>
                </body>
                </html>
                """.formatted(Html.escaped(page.title()), page.toRoot(), lists(page), page.html());
    }

    private String lists(Page page) {
        String made = """
                <li><a href="%1$sdocs/apidocs/index.html">Javadoc</a></li>
                <li><a href="%1$sbenchmarks/index.html">Measured frame rates</a></li>
                """.formatted(page.toRoot());
        return list("Project", page, path -> !path.startsWith("docs/"), "")
                + list("Guide", page, path -> path.startsWith("docs/") && path.indexOf('/', 5) < 0, made)
                + list("Lessons", page, path -> path.startsWith(LESSONS), "")
                + list("Decisions", page, path -> path.startsWith(DECISIONS), "");
    }

    private String list(String title, Page page, Predicate<String> which, String more) {
        String items = pages.stream()
                .filter(other -> which.test(other.source().toString().replace('\\', '/')))
                .map(other -> "<li><a href=\"" + page.toRoot()
                        + other.address().toString().replace('\\', '/') + "\""
                        + (other.equals(page) ? " aria-current=\"page\"" : "") + ">" + Html.escaped(other.title())
                        + "</a></li>\n")
                .collect(Collectors.joining());
        boolean open = which.test(page.source().toString().replace('\\', '/')) || title.equals("Guide");
        return "<details" + (open ? " open" : "") + "><summary>" + title + "</summary><ul>\n" + items + more
                + "</ul></details>\n";
    }
}
