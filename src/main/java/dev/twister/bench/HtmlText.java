package dev.twister.bench;

import java.util.List;
import java.util.stream.Collectors;

/** Pieces of HTML; whatever is not made here is text and is escaped. */
final class HtmlText {
    private HtmlText() {}

    static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** A cell of a table. */
    record Cell(String text, String style) {
        static Cell of(String text) {
            return new Cell(text, "");
        }
    }

    /** A table under the titles; the style is a class's name, or empty. */
    static String table(String style, List<Cell> titles, List<List<Cell>> rows) {
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
