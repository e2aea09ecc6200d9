package dev.twister.engine.tornado;

import static org.junit.jupiter.api.Assumptions.assumeFalse;

import dev.twister.engine.EngineOffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Named;
import uk.ac.manchester.tornado.api.TornadoRuntime;
import uk.ac.manchester.tornado.api.common.TornadoDevice;
import uk.ac.manchester.tornado.api.runtime.TornadoRuntimeProvider;

/** TornadoVM's devices on this machine; tests that request one are skipped with a reason where there is none. */
final class Devices {
    private Devices() {}

    static List<EngineOffer> offers() {
        List<EngineOffer> offers = new TornadoEngines().offers();
        List<EngineOffer> working = offers.stream().filter(EngineOffer::works).toList();
        assumeFalse(
                working.isEmpty(),
                () -> "no device to test the TornadoVM engine on: "
                        + offers.stream()
                                .flatMap(offer -> offer.obstacle().stream())
                                .collect(Collectors.joining("; ")));
        return working;
    }

    /** Returns the offers named by driver, for parameterized tests. */
    static List<Named<EngineOffer>> namedOffers() {
        return offers().stream().map(offer -> Named.of(offer.device(), offer)).toList();
    }

    static List<Named<TornadoDevice>> named() {
        return all().stream()
                .map(device -> Named.of(TornadoEngines.name(device), device))
                .toList();
    }

    static List<TornadoDevice> all() {
        offers();
        TornadoRuntime runtime = TornadoRuntimeProvider.getTornadoRuntime();
        List<TornadoDevice> devices = new ArrayList<>();
        for (int driver = 0; driver < runtime.getNumBackends(); driver++) {
            for (int index = 0; index < runtime.getBackend(driver).getNumDevices(); index++) {
                devices.add(runtime.getBackend(driver).getDevice(index));
            }
        }
        return devices;
    }

    static TornadoEngine openFirst() {
        return (TornadoEngine) offers().getFirst().opener().get();
    }
}
