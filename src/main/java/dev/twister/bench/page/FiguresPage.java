package dev.twister.bench.page;

import dev.twister.bench.PublishedFigures;
import dev.twister.bench.figures.RenderedFigure;
import dev.twister.files.WholeFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;

/** The paper's rendered figures as a self-contained HTML page. */
public final class FiguresPage {
    private FiguresPage() {}

    /**
     * Writes the page; on failure the file is unchanged.
     *
     * @throws IOException as for {@link WholeFile#write}
     */
    public static void write(List<RenderedFigure> figures, Path file) throws IOException {
        byte[] page = HtmlText.page(
                        "Twister: the paper's figures",
                        "The paper's figures",
                        "The rendered figures of “" + PublishedFigures.PAPER + "” (" + PublishedFigures.AUTHORS
                                + "), made by Twister. Below each picture is the command that makes it; all engines"
                                + " render the same picture.",
                        sections(figures))
                .getBytes(StandardCharsets.UTF_8);
        WholeFile.write(file, out -> out.write(page));
    }

    /** One section per figure. */
    public static String sections(List<RenderedFigure> figures) {
        return figures.stream().map(FiguresPage::section).collect(Collectors.joining("\n"));
    }

    private static String section(RenderedFigure figure) {
        return "<section>\n<h2>" + HtmlText.escaped(figure.title()) + "</h2>\n<pre class=\"equation\">"
                + HtmlText.escaped(figure.equation()) + "</pre>\n<p>" + HtmlText.escaped(figure.sentence())
                + "</p>\n<div class=\"pictures\">\n"
                + figure.pictures().stream().map(FiguresPage::picture).collect(Collectors.joining())
                + "</div>\n</section>\n";
    }

    private static String picture(RenderedFigure.Picture picture) {
        return "<figure>"
                + HtmlText.image(
                        picture.caption(), picture.type(), picture.content(), picture.width(), picture.height())
                + "<figcaption>" + HtmlText.escaped(picture.caption()) + " Scene: <code>"
                + HtmlText.escaped(picture.scene()) + "</code><pre class=\"command\">"
                + HtmlText.escaped(picture.command()) + "</pre></figcaption></figure>\n";
    }
}
