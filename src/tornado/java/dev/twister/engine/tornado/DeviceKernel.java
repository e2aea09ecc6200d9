package dev.twister.engine.tornado;

/** The kernel, loaded for devices: once, since TornadoVM keeps what it knows of a method for good. */
final class DeviceKernel {
    static final DrawTask DRAW = DeviceClassLoader.load(TornadoKernel.class, DrawTask.class);

    private DeviceKernel() {}
}
