package dev.twister.bench.page;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.stream.Collectors;

/** Builds HTML; text parameters are escaped. */
public final class HtmlText {
    private static final String STYLE = "paper.css";

    private HtmlText() {}

    /**
     * A whole page including its style sheet.
     *
     * @param title for the browser's window; text, like heading and lead
     * @param content HTML
     */
    public static String page(String title, String heading, String lead, String content) throws IOException {
        return """
                <!DOCTYPE html>
                <html lang="en">
                <head>
                <meta charset="utf-8">
                <meta name="viewport" content="width=device-width, initial-scale=1">
                <title>%s</title>
                <style>
                %s</style>
                </head>
                <body>
                <main>
                <h1>%s</h1>
                <p class="lead">%s</p>
                %s</main>
                </body>
                </html>
                """.formatted(escaped(title), resource(STYLE), escaped(heading), escaped(lead), content);
    }

    /**
     * An image element with embedded data. Inline SVG is not used, because ids in several SVG documents would clash.
     */
    public static String image(String description, String type, byte[] content, int width, int height) {
        return "<img alt=\"" + escaped(description) + "\" width=\"" + width + "\" height=\"" + height
                + "\" src=\"data:image/" + type + ";base64,"
                + Base64.getEncoder().encodeToString(content) + "\">";
    }

    /** A style sheet or a script of the pages. */
    public static String resource(String name) throws IOException {
        try (InputStream stream = HtmlText.class.getResourceAsStream(name)) {
            if (stream == null) {
                throw new IOException("Twister's own " + name + " is missing from its jar");
            }
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    public static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** A table cell. */
    public record Cell(String text, String style) {
        public static Cell of(String text) {
            return new Cell(text, "");
        }
    }

    /** A table with titles; the style is a CSS class, or empty. */
    public static String table(String style, List<Cell> titles, List<List<Cell>> rows) {
        String head = titles.isEmpty() ? "" : "<thead>" + row("th", titles) + "</thead>\n";
        return "<div class=\"scroll\"><table" + attribute(style) + ">\n" + head + "<tbody>\n"
                + rows.stream().map(row -> row("td", row)).collect(Collectors.joining("\n"))
                + "\n</tbody></table></div>\n";
    }

    private static String row(String element, List<Cell> cells) {
        return cells.stream()
                .map(cell ->
                        "<" + element + attribute(cell.style()) + ">" + escaped(cell.text()) + "</" + element + ">")
                .collect(Collectors.joining("", "<tr>", "</tr>"));
    }

    private static String attribute(String style) {
        return style.isEmpty() ? "" : " class=\"" + style + "\"";
    }
}
