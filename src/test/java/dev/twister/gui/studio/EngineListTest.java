package dev.twister.gui.studio;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.JvmEngines;
import java.util.List;
import org.junit.jupiter.api.Test;

class EngineListTest {
    @Test
    void enginesThatCannotRunComeLastSoThatTheArrowKeysReachAllOthers() {
        EngineOffer one = JvmEngines.parallel();
        EngineOffer none = EngineOffer.impossible("tornado", "", "", "no TornadoVM SDK was found");
        EngineOffer other = EngineOffer.impossible("gpu", "", "", "no driver");

        assertThat(EngineList.workableFirst(List.of(none, one, other))).containsExactly(one, none, other);
        assertThat(EngineList.workableFirst(List.of(one, none))).containsExactly(one, none);
    }
}
