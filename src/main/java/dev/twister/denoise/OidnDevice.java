package dev.twister.denoise;

import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;

/** A device of Open Image Denoise: the fastest one that it finds, or the one in its variable OIDN_DEFAULT_DEVICE. */
@SuppressWarnings("restricted") // native functions
final class OidnDevice implements AutoCloseable {
    private static final int FIRST_MAJOR = 2;
    private static final int VERSIONS = 100;
    private static final int DEFAULT_TYPE = 0;
    private static final int STORAGE_OF_HOST = 1;
    private static final String[] TYPES = {"device", "CPU", "SYCL", "CUDA", "HIP", "Metal"};

    private final OidnFunctions library;
    private final MemorySegment device;
    private final String version;

    /**
     * Opens the device.
     *
     * @throws DenoiseException if the library is another one, is too old, or has no device; the message lacks its name
     */
    OidnDevice(OidnFunctions library) {
        this.library = library;
        if (!library.has("oidnNewDevice")) {
            throw new DenoiseException("is not Open Image Denoise: it has no function oidnNewDevice");
        }
        if (!library.has("oidnGetDeviceInt") || !library.has("oidnNewBufferWithStorage")) {
            throw new DenoiseException("is Open Image Denoise 1; version 2.0 or newer is needed");
        }
        device = library.pointer("oidnNewDevice", DEFAULT_TYPE);
        check();
        library.run("oidnCommitDevice", device);
        check();
        int number = library.number("oidnGetDeviceInt", device, "version");
        version = number / (VERSIONS * VERSIONS) + "." + number / VERSIONS % VERSIONS + "." + number % VERSIONS;
        if (number / (VERSIONS * VERSIONS) < FIRST_MAJOR) {
            throw new DenoiseException("is Open Image Denoise " + version + "; version 2.0 or newer is needed");
        }
    }

    OidnFunctions library() {
        return library;
    }

    /** Such as {@code 2.5.1, CPU}. */
    String text() {
        int type = library.number("oidnGetDeviceInt", device, "type");
        return version + ", " + (type > 0 && type < TYPES.length ? TYPES[type] : TYPES[0]);
    }

    /** A filter for rendered pictures. */
    MemorySegment newFilter() {
        MemorySegment filter = library.pointer("oidnNewFilter", device, "RT");
        check();
        return filter;
    }

    /** A buffer that the JVM and the device can access. */
    MemorySegment newBuffer(long bytes) {
        MemorySegment buffer = library.pointer("oidnNewBufferWithStorage", device, bytes, STORAGE_OF_HOST);
        check();
        return buffer;
    }

    /**
     * Throws the library's last error.
     *
     * @throws DenoiseException with the library's own words
     */
    void check() {
        try (Arena arena = Arena.ofConfined()) {
            MemorySegment message = arena.allocate(ValueLayout.ADDRESS);
            if (library.number("oidnGetDeviceError", device, message) != 0) {
                MemorySegment text = message.get(ValueLayout.ADDRESS, 0);
                throw new DenoiseException("failed: "
                        + (text.equals(MemorySegment.NULL)
                                ? "no reason given"
                                : text.reinterpret(Long.MAX_VALUE).getString(0)));
            }
        }
    }

    @Override
    public void close() {
        library.run("oidnReleaseDevice", device);
    }
}
