package dev.twister.mesh;

/** The transform of texture coordinates in KHR_texture_transform. */
record TextureLayout(double scaleU, double scaleV, double cosine, double sine, double offsetU, double offsetV) {
    static final TextureLayout PLAIN = new TextureLayout(1, 1, 1, 0, 0, 0);

    static TextureLayout of(GltfPlace transform) {
        double[] offset = transform.at("offset").numbersOr(0, 0);
        double[] scale = transform.at("scale").numbersOr(1, 1);
        double rotation = transform.at("rotation").numberOr(0);
        return new TextureLayout(scale[0], scale[1], Math.cos(rotation), Math.sin(rotation), offset[0], offset[1]);
    }

    double u(double u, double v) {
        return offsetU + cosine * scaleU * u + sine * scaleV * v;
    }

    double v(double u, double v) {
        return offsetV - sine * scaleU * u + cosine * scaleV * v;
    }
}
