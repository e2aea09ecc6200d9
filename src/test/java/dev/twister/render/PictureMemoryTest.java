package dev.twister.render;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.image.PictureSize;
import org.junit.jupiter.api.Test;

class PictureMemoryTest {
    @Test
    void theSufficientLimitCountsWhatIsInUse() {
        PictureMemory.Shortage shortage = new PictureMemory.Shortage(PictureSize.HD, 1100, 1000, 4000);

        assertThat(shortage.sufficientLimit()).isEqualTo(4000 + 100 + 1024);
    }
}
