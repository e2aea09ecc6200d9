package dev.twister.engine;

import com.google.auto.service.AutoService;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;

/** Says how to get TornadoVM's engines where they are not built. */
@AutoService(EngineProvider.class)
public final class MissingTornado implements EngineProvider {
    /** The family name of TornadoVM's engines. */
    public static final String TORNADO = "tornado";

    @Override
    public List<EngineOffer> offers() {
        return isBuilt()
                ? List.of()
                : List.of(EngineOffer.impossible(
                        TORNADO,
                        "any OpenCL, CUDA or Metal device",
                        "the kernel compiled by TornadoVM for an accelerator",
                        "no TornadoVM SDK was found. Install one (sdk install tornadovm, or set TORNADOVM_HOME),"
                                + " then start"
                                + " with the command twister, which builds the engine and runs it"));
    }

    @Override
    public Optional<String> devices() {
        return Optional.of(TORNADO);
    }

    private boolean isBuilt() {
        return ServiceLoader.load(EngineProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .anyMatch(other ->
                        !(other instanceof MissingTornado) && other.devices().equals(devices()));
    }
}
