package dev.twister.engine.tornado;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.FrameFit;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Optional;
import uk.ac.manchester.tornado.api.common.TornadoDevice;

/** Draws on a device of TornadoVM's. The first frame of a size takes seconds: TornadoVM compiles the kernel then. */
final class TornadoEngine implements Engine {
    private final String id;
    private final String name;
    private final TornadoDevice device;
    private final DrawTask kernel;
    private Optional<DevicePlan> plan = Optional.empty();

    TornadoEngine(String id, String name, TornadoDevice device) {
        this(id, name, device, DeviceKernel.DRAW);
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
            if (plan.filter(current -> current.fits(input, frame)).isEmpty()) {
                close();
                plan = Optional.of(new DevicePlan(device, input, frame.isLinear(), kernel));
            }
            frame.setTimes(plan.orElseThrow().draw(input, frame));
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

    /** What is compiled and on the device now; another frame that fits it is drawn by the same. */
    Optional<DevicePlan> plan() {
        return plan;
    }

    @Override
    public void close() {
        plan.ifPresent(DevicePlan::close);
        plan = Optional.empty();
    }
}
