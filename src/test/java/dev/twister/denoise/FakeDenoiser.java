package dev.twister.denoise;

import java.util.Optional;

/**
 * A denoiser that shows what it was given: {@code radiance + 10 * albedo + 100 * normal}. It is offered while the
 * property {@value #PROPERTY} is true.
 */
public final class FakeDenoiser implements DenoiserProvider, Denoiser {
    public static final String PROPERTY = "twister.test.denoiser";

    @Override
    public Optional<DenoiserOffer> offer() {
        return Boolean.getBoolean(PROPERTY)
                ? Optional.of(DenoiserOffer.working("fake", FakeDenoiser::new))
                : Optional.empty();
    }

    @Override
    public float[] denoise(NoisyPicture picture) {
        float[] sum = new float[picture.values()];
        for (int i = 0; i < sum.length; i++) {
            int at = i;
            sum[i] = value(picture.radiance(), at)
                    + picture.guides()
                            .map(guides -> 10 * value(guides.albedo(), at) + 100 * value(guides.normal(), at))
                            .orElse(0f);
        }
        return sum;
    }

    private static float value(Plane plane, int at) {
        return plane.values()[plane.first() + at];
    }

    @Override
    public void close() {
        // Holds nothing.
    }
}
