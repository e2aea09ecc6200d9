package dev.twister.oracle;

import dev.twister.world.FrameInput;
import dev.twister.world.World;
import java.util.Optional;

/** One world that shows many scenes in turn, as the window does: it keeps the tables of albedos that it has computed. */
public final class ShownWorld {
    private Optional<World> world = Optional.empty();

    /** The scene's frame at time 0. */
    public FrameInput input(LitScene lit) {
        World shown = world.filter(kept -> kept.origin().equals(World.originOf(lit.scene())))
                .orElseGet(lit::world);
        world = Optional.of(shown);
        shown.show(lit.scene(), lit.images(), lit.meshes());
        return shown.snapshot();
    }
}
