package dev.twister.scene.material;

/**
 * How a map is read. Maps on spheres and the plane have the default.
 *
 * @param across what is beyond its left and right border
 * @param down what is beyond its upper and lower border
 * @param nearest whether a place has the color of the nearest texel; otherwise it is bilinear between texel centers
 * @param coordinates which of a mesh's texture coordinates place it, from 0 on
 */
public record Sampler(Wrap across, Wrap down, boolean nearest, int coordinates) {
    public static final Sampler DEFAULT = new Sampler(Wrap.REPEAT, Wrap.REPEAT, false, 0);
}
