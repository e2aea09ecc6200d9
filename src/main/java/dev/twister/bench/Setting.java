package dev.twister.bench;

import dev.twister.image.PictureSize;
import dev.twister.scene.Rendering;

/**
 * Size and shading of a measured picture.
 *
 * @param shadowSamples points on the light's disc
 * @param bounces limit of reflections
 */
public record Setting(PictureSize size, int shadowSamples, int bounces) {
    Rendering over(Rendering settings) {
        return settings.withSize(size.width(), size.height())
                .withShadows(shadowSamples)
                .withBounces(bounces);
    }

    /** Shadow samples and bounces as text. */
    String shading() {
        return ReportNumbers.counted(shadowSamples, "shadow sample") + ", " + ReportNumbers.counted(bounces, "bounce");
    }

    @Override
    public String toString() {
        return size + ", " + shading();
    }
}
