package dev.twister.film;

/**
 * Size, rate and length of a film.
 *
 * @param width in pixels
 * @param height in pixels
 * @param rate frames per second
 * @param frames number of frames, 1 or more
 * @param alpha whether an animated PNG has the pixels' alpha, for colors that are not multiplied by it
 */
public record FilmFormat(int width, int height, double rate, int frames, boolean alpha) {}
