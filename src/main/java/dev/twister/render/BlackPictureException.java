package dev.twister.render;

/** The exposure should be set by a picture without any light. */
public final class BlackPictureException extends RuntimeException {
    private static final long serialVersionUID = 1;

    BlackPictureException() {
        super("the picture is black");
    }
}
