package dev.twister.denoise;

import java.util.Optional;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * A denoiser that shows what it was given: {@code radiance + 10 * albedo + 100 * normal}. It is offered while the
 * property {@value #PROPERTY} is true, such as in the tests of a class with {@link Offered}.
 */
public final class FakeDenoiser implements DenoiserProvider, Denoiser {
    public static final String PROPERTY = "twister.test.denoiser";

    /** Offers it during each test. */
    public static final class Offered implements BeforeEachCallback, AfterEachCallback {
        @Override
        public void beforeEach(ExtensionContext context) {
            System.setProperty(PROPERTY, "true");
        }

        @Override
        public void afterEach(ExtensionContext context) {
            System.clearProperty(PROPERTY);
        }
    }

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
