package dev.twister.denoise;

import java.lang.foreign.MemorySegment;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** Runs the filters of Open Image Denoise, a neural network, in this process. */
@SuppressWarnings("restricted") // native functions
final class OidnFilters implements AutoCloseable {
    private static final String RADIANCE = "color";
    private static final String OUTPUT = "output";
    private static final List<String> GUIDES = List.of("albedo", "normal");
    private static final int THREE_FLOATS = 3;
    private static final int CHANNELS = 3;

    /** Limit of the library's own memory in megabytes, approximately. */
    private static final int MOST_MEGABYTES = 2048;

    private final OidnDevice device;

    /**
     * Loads a library.
     *
     * @param place a file, or a name for the system's loader
     * @throws DenoiseException if it cannot be used; the message continues its name
     */
    OidnFilters(String place) {
        device = new OidnDevice(new OidnFunctions(place));
    }

    /** Version and device, for display. */
    String text() {
        return device.text();
    }

    /**
     * Allocates images of a size.
     *
     * @param guided whether there are albedo and normal too
     */
    Images images(int width, int height, boolean guided) {
        return new Images(device, width, height, guided);
    }

    /**
     * Removes the noise of the input images; changes the guides.
     *
     * @param scale {@link InputScale}
     */
    void denoise(Images images, float scale) {
        OidnFunctions library = device.library();
        // Guides are averages of few samples too; what noise is left in them stays in the picture.
        for (String guide : images.guides()) {
            filter(filter -> {
                images.set(filter, guide, guide);
                images.set(filter, OUTPUT, guide);
            });
        }
        filter(filter -> {
            images.set(filter, RADIANCE, RADIANCE);
            images.set(filter, OUTPUT, OUTPUT);
            for (String guide : images.guides()) {
                images.set(filter, guide, guide);
            }
            library.run(
                    "oidnSetFilterBool", filter, "cleanAux", !images.guides().isEmpty());
            library.run("oidnSetFilterBool", filter, "hdr", true);
            library.run("oidnSetFilterFloat", filter, "inputScale", scale);
        });
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

    /** Three floats per pixel for each input and for the output. */
    static final class Images implements AutoCloseable {
        private final OidnDevice device;
        private final long width;
        private final long height;
        private final List<String> guides;
        private final Map<String, MemorySegment> buffers = new LinkedHashMap<>();

        Images(OidnDevice device, int width, int height, boolean guided) {
            this.device = device;
            this.width = width;
            this.height = height;
            guides = guided ? GUIDES : List.of();
            add(RADIANCE);
            guides.forEach(this::add);
            add(OUTPUT);
        }

        private void add(String name) {
            buffers.put(name, device.newBuffer(bytes()));
        }

        private long bytes() {
            return Float.BYTES * CHANNELS * width * height;
        }

        private List<String> guides() {
            return guides;
        }

        /** The images to fill: the radiance, and albedo and normal if there are guides. */
        List<ByteBuffer> inputs() {
            return buffers.keySet().stream()
                    .filter(name -> !name.equals(OUTPUT))
                    .map(this::data)
                    .toList();
        }

        /** The picture without noise. */
        ByteBuffer output() {
            return data(OUTPUT);
        }

        private ByteBuffer data(String name) {
            return device.library()
                    .pointer("oidnGetBufferData", buffers.get(name))
                    .reinterpret(bytes())
                    .asByteBuffer()
                    .order(ByteOrder.nativeOrder());
        }

        /** Makes a buffer an image of the filter. */
        private void set(MemorySegment filter, String name, String buffer) {
            device.library()
                    .run(
                            "oidnSetFilterImage",
                            filter,
                            name,
                            buffers.get(buffer),
                            THREE_FLOATS,
                            width,
                            height,
                            0L,
                            0L,
                            0L);
            device.check();
        }

        @Override
        public void close() {
            buffers.values().forEach(buffer -> device.library().run("oidnReleaseBuffer", buffer));
        }
    }
}
