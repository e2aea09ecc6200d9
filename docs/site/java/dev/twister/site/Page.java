package dev.twister.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;
import org.commonmark.renderer.text.TextContentRenderer;

/**
 * A page of the site.
 *
 * @param source its Markdown file, in the project's folder
 * @param title its first heading
 * @param html its content
 * @param text its words, for the search
 */
record Page(Path source, String title, String html, String text) {
    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), HeadingAnchorExtension.create());
    private static final Pattern HEADING = Pattern.compile("(?m)^# (.+)$");
    private static final Pattern TO_MARKDOWN = Pattern.compile("href=\"(?![a-z]+:)([^\"#]*)\\.md(#[^\"]*)?\"");
    private static final String INDEX = "README";

    static Page read(Path file) throws IOException {
        String markdown = Files.readString(file);
        Node document = Parser.builder().extensions(EXTENSIONS).build().parse(markdown);
        String html = HtmlRenderer.builder().extensions(EXTENSIONS).build().render(document);
        String title = HEADING.matcher(markdown)
                .results()
                .map(found -> found.group(1).replace("`", ""))
                .findFirst()
                .orElse(file.getFileName().toString());
        return new Page(
                file,
                title,
                TO_MARKDOWN
                        .matcher(html)
                        .replaceAll(link -> "href=\"" + renamed(link.group(1)) + ".html"
                                + (link.group(2) == null ? "" : link.group(2)) + "\""),
                TextContentRenderer.builder().extensions(EXTENSIONS).build().render(document));
    }

    /** Its file in the site's folder. */
    Path address() {
        String path = source.toString().replace('\\', '/');
        return Path.of(renamed(path.substring(0, path.length() - ".md".length())) + ".html");
    }

    /** From its folder to the site's. */
    String toRoot() {
        return "../".repeat(address().getNameCount() - 1);
    }

    private static String renamed(String path) {
        return path.endsWith(INDEX) ? path.substring(0, path.length() - INDEX.length()) + "index" : path;
    }
}
