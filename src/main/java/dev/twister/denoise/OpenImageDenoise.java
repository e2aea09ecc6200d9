package dev.twister.denoise;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Intel's Open Image Denoise, a neural network; in bands if the picture is large. */
@SuppressWarnings("restricted") // native functions
final class OpenImageDenoise implements Denoiser {
    private static final String RADIANCE = "color";
    private static final String ALBEDO = "albedo";
    private static final String NORMAL = "normal";
    private static final String OUTPUT = "output";
    private static final int THREE_FLOATS = 3;
    private static final int CHANNELS = 3;

    /** Limit of the library's own memory in megabytes, approximately. */
    private static final int MOST_MEGABYTES = 2048;

    private final OidnDevice device;
    private final long mostPixels;

    /** Denoises on the device, which is closed with this object. */
    OpenImageDenoise(OidnDevice device) {
        this(device, Long.MAX_VALUE);
    }

    /** As above, in bands of at most {@code mostPixels} pixels. */
    OpenImageDenoise(OidnDevice device, long mostPixels) {
        this.device = device;
        this.mostPixels = mostPixels;
    }

    /** Version and device, for display. */
    String text() {
        return device.text();
    }

    @Override
    public float[] denoise(NoisyPicture picture) {
        float[] denoised = new float[picture.values()];
        Bands bands = mostPixels == Long.MAX_VALUE
                ? Bands.of(picture.width(), picture.height())
                : Bands.of(picture.width(), picture.height(), mostPixels);
        float scale = InputScale.of(picture);
        try (Images images = new Images(device, bands, picture.guides().isPresent())) {
            for (int band = 0; band < bands.count(); band++) {
                denoise(picture, bands, band, scale, images, denoised);
            }
        }
        return denoised;
    }

    private void denoise(NoisyPicture picture, Bands bands, int band, float scale, Images images, float[] denoised) {
        int width = picture.width();
        int rows = bands.bottom(band) - bands.top(band);
        images.load(RADIANCE, picture.radiance(), bands, band);
        picture.guides().ifPresent(guides -> {
            images.load(ALBEDO, guides.albedo(), bands, band);
            images.load(NORMAL, guides.normal(), bands, band);
            // Guides are averages of few samples too; what noise is left in them stays in the picture.
            for (String guide : List.of(ALBEDO, NORMAL)) {
                filter(filter -> {
                    images.set(filter, guide, guide, width, rows);
                    images.set(filter, OUTPUT, guide, width, rows);
                });
            }
        });
        filter(filter -> {
            OidnFunctions library = device.library();
            images.set(filter, RADIANCE, RADIANCE, width, rows);
            images.set(filter, OUTPUT, OUTPUT, width, rows);
            if (picture.guides().isPresent()) {
                images.set(filter, ALBEDO, ALBEDO, width, rows);
                images.set(filter, NORMAL, NORMAL, width, rows);
                library.run("oidnSetFilterBool", filter, "cleanAux", true);
            }
            library.run("oidnSetFilterBool", filter, "hdr", true);
            library.run("oidnSetFilterFloat", filter, "inputScale", scale);
        });
        int kept = bands.end(band) - bands.first(band);
        MemorySegment.copy(
                images.data(OUTPUT),
                ValueLayout.JAVA_FLOAT,
                (long) Float.BYTES * CHANNELS * width * (bands.first(band) - bands.top(band)),
                denoised,
                CHANNELS * width * bands.first(band),
                CHANNELS * width * kept);
    }

    /** Runs a filter with the settings that the caller makes. */
    private void filter(Consumer<MemorySegment> settings) {
        OidnFunctions library = device.library();
        MemorySegment filter = device.newFilter();
        try {
            settings.accept(filter);
            library.run("oidnSetFilterInt", filter, "maxMemoryMB", MOST_MEGABYTES);
            library.run("oidnCommitFilter", filter);
            library.run("oidnExecuteFilter", filter);
            device.check();
        } finally {
            library.run("oidnReleaseFilter", filter);
        }
    }

    @Override
    public void close() {
        device.close();
    }

    /** Buffers for one band of each image. */
    private static final class Images implements AutoCloseable {
        private final OidnDevice device;
        private final long bytes;
        private final Optional<MemorySegment> albedo;
        private final Optional<MemorySegment> normal;
        private final MemorySegment radiance;
        private final MemorySegment output;

        Images(OidnDevice device, Bands bands, boolean guided) {
            this.device = device;
            bytes = (long) Float.BYTES * CHANNELS * bands.width() * bands.mostRows();
            radiance = device.newBuffer(bytes);
            output = device.newBuffer(bytes);
            albedo = guided ? Optional.of(device.newBuffer(bytes)) : Optional.empty();
            normal = guided ? Optional.of(device.newBuffer(bytes)) : Optional.empty();
        }

        private MemorySegment buffer(String name) {
            return switch (name) {
                case ALBEDO -> albedo.orElseThrow();
                case NORMAL -> normal.orElseThrow();
                case OUTPUT -> output;
                default -> radiance;
            };
        }

        MemorySegment data(String name) {
            return device.library().pointer("oidnGetBufferData", buffer(name)).reinterpret(bytes);
        }

        /** Copies a band of a plane into its buffer. */
        void load(String name, Plane plane, Bands bands, int band) {
            int stride = CHANNELS * bands.width();
            int rows = bands.bottom(band) - bands.top(band);
            MemorySegment data = data(name);
            int from = plane.first() + stride * bands.top(band);
            MemorySegment.copy(plane.values(), from, data, ValueLayout.JAVA_FLOAT, 0, stride * rows);
            for (int i = 0; i < stride * rows; i++) {
                if (!Float.isFinite(plane.values()[from + i])) {
                    data.setAtIndex(ValueLayout.JAVA_FLOAT, i, 0f);
                }
            }
        }

        /** Makes a buffer an image of the filter. */
        void set(MemorySegment filter, String name, String buffer, int width, int rows) {
            device.library()
                    .run(
                            "oidnSetFilterImage",
                            filter,
                            name,
                            buffer(buffer),
                            THREE_FLOATS,
                            (long) width,
                            (long) rows,
                            0L,
                            0L,
                            0L);
            device.check();
        }

        @Override
        public void close() {
            device.library().run("oidnReleaseBuffer", radiance);
            device.library().run("oidnReleaseBuffer", output);
            albedo.ifPresent(buffer -> device.library().run("oidnReleaseBuffer", buffer));
            normal.ifPresent(buffer -> device.library().run("oidnReleaseBuffer", buffer));
        }
    }
}
