package dev.twister.bench.figures;

import java.util.List;

/**
 * A rendered figure of the paper.
 *
 * @param equation what it shows, in plain text, with line feeds between lines
 * @param sentence what to look at
 */
public record RenderedFigure(String title, String equation, String sentence, List<Picture> pictures) {
    /**
     * A picture of the figure.
     *
     * @param scene its scene file, relative to Twister's folder
     * @param command the command that renders it, run in that folder
     * @param type format of the content: {@code png} or {@code svg+xml}
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Picture(
            String caption, String scene, String command, String type, byte[] content, int width, int height) {}
}
