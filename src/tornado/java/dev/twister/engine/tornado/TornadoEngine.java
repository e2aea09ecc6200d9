package dev.twister.engine.tornado;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.FrameFit;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import uk.ac.manchester.tornado.api.common.TornadoDevice;

/** Draws on a device of TornadoVM's. The first frame of a size takes seconds: TornadoVM compiles the kernel then. */
final class TornadoEngine implements Engine {
    /** Loaded once: TornadoVM keeps what it knows of a method until the JVM ends. */
    private static final DrawTask KERNEL = DeviceClassLoader.load(TornadoKernel.class, DrawTask.class);

    private final String id;
    private final String name;
    private final TornadoDevice device;
    private final DrawTask kernel;
    private final Map<Boolean, DevicePlan> planByLinear = new HashMap<>();
    private Optional<DevicePlan> last = Optional.empty();

    TornadoEngine(String id, String name, TornadoDevice device) {
        this(id, name, device, KERNEL);
    }

    TornadoEngine(String id, String name, TornadoDevice device, DrawTask kernel) {
        this.id = id;
        this.name = name;
        this.device = device;
        this.kernel = kernel;
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public String device() {
        return name;
    }

    @Override
    public void render(FrameInput input, Frame frame) {
        FrameFit.check(input, frame);
        try {
            DevicePlan plan = planFor(input, frame);
            last = Optional.of(plan);
            frame.setTimes(plan.draw(input, frame));
        } catch (EngineException e) {
            close();
            throw e;
        } catch (VirtualMachineError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // TornadoVM's compiler reports what it cannot compile as an Error of its own.
            close();
            throw new EngineException(DeviceFailure.message(name, e), e);
        }
    }

    /** A window draws 8-bit frames and linear ones by turns: each kind keeps its plan. */
    private DevicePlan planFor(FrameInput input, Frame frame) {
        boolean linear = frame.isLinear();
        DevicePlan known = planByLinear.get(linear);
        if (known != null && known.fits(input, frame)) {
            return known;
        }
        if (known != null) {
            planByLinear.remove(linear).close();
        }
        DevicePlan fresh = new DevicePlan(device, input, linear, kernel);
        planByLinear.put(linear, fresh);
        return fresh;
    }

    /** What drew the last frame; another frame that fits it is drawn by the same. */
    Optional<DevicePlan> plan() {
        return last;
    }

    @Override
    public void close() {
        planByLinear.values().forEach(DevicePlan::close);
        planByLinear.clear();
        last = Optional.empty();
    }
}
