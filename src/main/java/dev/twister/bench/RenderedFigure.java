package dev.twister.bench;

import java.util.List;

/**
 * A figure of the paper, rendered here.
 *
 * @param equation what it shows, in plain text; a line feed between lines
 * @param sentence what to look at
 */
public record RenderedFigure(String title, String equation, String sentence, List<Picture> pictures) {
    /**
     * One of its pictures.
     *
     * @param scene the file that it is made from, in Twister's folder
     * @param command that makes it, in the same folder
     * @param type of the content: {@code png} or {@code svg+xml}
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    public record Picture(
            String caption, String scene, String command, String type, byte[] content, int width, int height) {}
}
