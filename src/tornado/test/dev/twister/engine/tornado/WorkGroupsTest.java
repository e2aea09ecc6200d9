package dev.twister.engine.tornado;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import uk.ac.manchester.tornado.api.WorkerGrid2D;
import uk.ac.manchester.tornado.api.enums.TornadoDeviceType;

class WorkGroupsTest {
    @Test
    void theFastestGroupIsChosenAndKept() {
        WorkGroups groups = new WorkGroups(TornadoDeviceType.GPU, 1024);
        while (!groups.isChosen()) {
            groups.measured(groups.next().columns() == 16 ? 500 : 1000, 100);
        }
        groups.measured(1_000_000, 100);
        assertThat(groups.next()).isEqualTo(new WorkGroups.Group(16, 8));
    }

    @Test
    void picturesOfOtherSizesAreComparedByTheirPixels() {
        WorkGroups groups = new WorkGroups(TornadoDeviceType.GPU, 1024);
        while (!groups.isChosen()) {
            boolean best = groups.next().columns() == 8;
            groups.measured(best ? 9000 : 1000, best ? 10_000 : 1000);
        }
        assertThat(groups.next()).isEqualTo(new WorkGroups.Group(8, 8));
    }

    @Test
    void aDeviceGetsNoLargerGroupsThanItTakes() {
        WorkGroups groups = new WorkGroups(TornadoDeviceType.CPU, 128);
        while (!groups.isChosen()) {
            assertThat(groups.next()).isEqualTo(new WorkGroups.Group(16, 8));
            groups.measured(1000, 100);
        }
        assertThat(new WorkGroups(TornadoDeviceType.CPU, 1).next()).isEqualTo(new WorkGroups.Group(1, 1));
    }

    @Test
    void aGridIsOfWholeGroupsThatCoverAllPixels() {
        WorkerGrid2D grid = new WorkerGrid2D(1, 1);
        WorkGroups.cover(grid, new WorkGroups.Group(16, 8), 101, 57);
        assertThat(grid.getGlobalWork()).containsExactly(112, 64, 1);
        assertThat(grid.getLocalWork()).containsExactly(16, 8, 1);
    }
}
