package dev.twister.engine.tornado;

/** Frees what a device holds. A failure, as with a lost device, is only logged: the reason to stop is known already. */
final class Release {
    private static final System.Logger LOGGER = System.getLogger(Release.class.getName());

    /** One call to TornadoVM, which throws whatever its parts throw, its own Errors included. */
    @FunctionalInterface
    interface Step {
        void run() throws Exception;
    }

    private Release() {}

    static void quietly(Step step) {
        try {
            step.run();
        } catch (VirtualMachineError failure) {
            throw failure;
        } catch (Exception | Error failure) {
            LOGGER.log(System.Logger.Level.DEBUG, "the device's buffers could not be given back", failure);
        }
    }
}
