package dev.twister.mesh.input;

/** The transform of texture coordinates in KHR_texture_transform. */
public record TextureLayout(double scaleU, double scaleV, double cosine, double sine, double offsetU, double offsetV) {
    public static final TextureLayout PLAIN = new TextureLayout(1, 1, 1, 0, 0, 0);

    public double u(double u, double v) {
        return offsetU + cosine * scaleU * u + sine * scaleV * v;
    }

    public double v(double u, double v) {
        return offsetV - sine * scaleU * u + cosine * scaleV * v;
    }
}
