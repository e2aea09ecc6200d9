package dev.twister.sky.webp;

/**
 * A decoded picture.
 *
 * @param argb {@code width * height} texels, row by row from the top: alpha in the highest 8 bits, then red, green,
 *     blue; not premultiplied
 * @param hasAlpha whether the file says that texels may be transparent; otherwise alpha means nothing
 */
@SuppressWarnings("ArrayRecordComponent") // read in place
public record WebpImage(int width, int height, int[] argb, boolean hasAlpha) {}
