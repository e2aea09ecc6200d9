package dev.twister.engine.tornado;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.EngineProvider;
import dev.twister.engine.MissingTornado;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uk.ac.manchester.tornado.api.TornadoBackend;
import uk.ac.manchester.tornado.api.TornadoRuntime;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.runtime.TornadoRuntimeProvider;

/** Offers an engine for each device of each TornadoVM backend. */
public final class TornadoEngines implements EngineProvider {
    private static final String DRIVER =
            "Install a driver (OpenCL: your GPU's, or PoCL for the CPU: apt install pocl-opencl-icd)";

    /** Set by the SDK's argument file. */
    private static final String RUNTIME_PROPERTY = "tornado.load.runtime.implementation";

    /** Terminal colors in TornadoVM's messages. */
    private static final Pattern COLORS = Pattern.compile("\u001B\\[[0-9;]*m");

    /** Parts of TornadoVM's messages that are not true here: nothing falls back to sequential execution. */
    private static final Pattern NOISE =
            Pattern.compile("\\[WARNING]|\\.?\\s*Deoptimizing to sequential execution\\.?");

    private static final Pattern DRIVER_VERSION = Pattern.compile("^Driver version *: *(\\S.*)$", Pattern.MULTILINE);

    private static final Map<String, String> BACKENDS = Map.of("OPENCL", "OpenCL", "METAL", "Metal");

    private static final String DESCRIPTION = "the kernel compiled by TornadoVM for a device";

    @Override
    public List<EngineOffer> offers() {
        try {
            List<EngineOffer> offers = found();
            return offers.isEmpty() ? List.of(impossible("TornadoVM finds no device. " + DRIVER)) : offers;
        } catch (VirtualMachineError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            return List.of(impossible(explain(e, System.getProperty(RUNTIME_PROPERTY) != null) + untested()));
        }
    }

    /**
     * Says why TornadoVM does not start, and what to do.
     *
     * @param hasOptions whether this JVM has the SDK's options
     */
    static String explain(Throwable problem, boolean hasOptions) {
        Throwable cause = problem;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        String message = COLORS.matcher(String.valueOf(cause.getMessage())).replaceAll("");
        message = NOISE.matcher(message).replaceAll("").strip();
        return "TornadoVM does not start in this JVM (" + cause.getClass().getSimpleName() + ": " + message + "). "
                // Without any driver, TornadoVM's OpenCL backend fails instead of finding no devices.
                + (hasOptions ? DRIVER : "Start with scripts/twister, which gives the JVM the SDK's options");
    }

    @Override
    public Optional<String> devices() {
        return Optional.of(MissingTornado.TORNADO);
    }

    /** Synchronized: TornadoVM's runtime is global and starts at the first call. */
    private static synchronized List<EngineOffer> found() {
        TornadoOptions.set();
        TornadoRuntime runtime = TornadoRuntimeProvider.getTornadoRuntime();
        String description = DESCRIPTION + untested();
        List<EngineOffer> offers = new ArrayList<>();
        for (int driver = 0; driver < runtime.getNumBackends(); driver++) {
            TornadoBackend backend = runtime.getBackend(driver);
            for (int index = 0; index < backend.getNumDevices(); index++) {
                TornadoDevice device = backend.getDevice(index);
                String id = MissingTornado.TORNADO + ":" + driver + ":" + index;
                String name = name(device);
                EngineOffer offer = EngineOffer.working(id, name, description, () -> open(id, name, device));
                offers.add(driverVersion(device.getPhysicalDevice().getDeviceInfo())
                        .map(offer::withDriver)
                        .orElse(offer));
            }
        }
        return offers;
    }

    /** What to add to a sentence where the SDK is newer than what was tested. */
    private static String untested() {
        return SdkVersion.installed()
                .flatMap(SdkVersion::warning)
                .map(warning -> ". " + warning)
                .orElse("");
    }

    private static Engine open(String id, String name, TornadoDevice device) {
        try {
            return new TornadoEngine(id, name, device);
        } catch (VirtualMachineError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            throw new EngineException(DeviceFailure.message(name, e), e);
        }
    }

    /** The device's name with backend and driver, because two drivers may offer the same device. */
    static String name(TornadoDevice device) {
        String backend = device.getTornadoVMBackend().name();
        return device.getPhysicalDevice().getDeviceName().strip() + " (" + BACKENDS.getOrDefault(backend, backend)
                + ", " + device.getPlatformName().strip() + ")";
    }

    /**
     * Extracts the driver's version from TornadoVM's device information, which has no method for it; empty if it is
     * missing.
     */
    static Optional<String> driverVersion(String deviceInfo) {
        Matcher line = DRIVER_VERSION.matcher(deviceInfo);
        return line.find() ? Optional.of(line.group(1).strip()) : Optional.empty();
    }

    private static EngineOffer impossible(String obstacle) {
        return EngineOffer.impossible(
                MissingTornado.TORNADO, "any OpenCL, CUDA or Metal device", DESCRIPTION, obstacle);
    }
}
