package dev.twister.engine.tornado;

import dev.twister.engine.ConvergingPicture;
import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.FrameFit;
import dev.twister.image.Frame;
import dev.twister.image.FrameStop;
import dev.twister.world.FrameInput;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import uk.ac.manchester.tornado.api.common.TornadoDevice;

/**
 * Renders on a TornadoVM device. The first frame of each variant takes seconds, because TornadoVM compiles the kernel.
 */
final class TornadoEngine implements Engine {
    /** Loaded once, because TornadoVM caches data about methods until the JVM exits. */
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

    /** TornadoVM's virtual devices, for which kernels are only printed, do not say it. */
    private static long mostItemsOfAGroup(TornadoDevice device) {
        return Optional.ofNullable(device.getPhysicalDevice().getDeviceMaxWorkGroupSize())
                .map(most -> most[0])
                .orElse(Long.MAX_VALUE);
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
        if (input.samplesPerPixel() > TornadoKernel.MOST_SAMPLES) {
            ConvergingPicture.draw(this, input, frame, 0, input.samplesPerPixel(), _ -> {});
        } else {
            renderAtOnce(input, frame);
        }
    }

    private void renderAtOnce(FrameInput input, Frame frame) {
        FrameStop stop = FrameStop.of(frame);
        stop.check();
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
            // TornadoVM's compiler throws its own Errors.
            close();
            throw new EngineException(DeviceFailure.message(name, e), e);
        }
        stop.check();
    }

    /** The window alternates between 8-bit and linear frames, so each kind keeps its plan. */
    private DevicePlan planFor(FrameInput input, Frame frame) {
        boolean linear = frame.isLinear();
        DevicePlan known = planByLinear.get(linear);
        if (known != null && known.fits(input, frame)) {
            return known;
        }
        if (known != null) {
            planByLinear.remove(linear).close();
        }
        DevicePlan fresh = new DevicePlan(
                device, input, linear, kernel, new WorkGroups(device.getDeviceType(), mostItemsOfAGroup(device)));
        planByLinear.put(linear, fresh);
        return fresh;
    }

    /** The plan that rendered the last frame. */
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
