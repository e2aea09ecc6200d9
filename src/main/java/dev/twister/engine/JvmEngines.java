package dev.twister.engine;

import com.google.auto.service.AutoService;
import java.util.List;

/** The engines that need nothing but the JVM. */
@AutoService(EngineProvider.class)
public final class JvmEngines implements EngineProvider {
    @Override
    public List<EngineOffer> offers() {
        return List.of();
    }
}
