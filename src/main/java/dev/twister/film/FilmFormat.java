package dev.twister.film;

/**
 * A film's size and speed.
 *
 * @param width in pixels
 * @param height in pixels
 * @param rate frames a second
 * @param frames how many, 1 or more
 */
public record FilmFormat(int width, int height, double rate, int frames) {}
