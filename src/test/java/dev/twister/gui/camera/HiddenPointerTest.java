package dev.twister.gui.camera;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.camera.CameraMouse.HiddenPointer;
import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Point2D;
import javafx.geometry.Rectangle2D;
import org.junit.jupiter.api.Test;

/** The second of two screens, 800 pixels wide and 600 high. */
class HiddenPointerTest {
    private static final Point2D START = at(1300, 200);
    private static final Point2D MIDDLE = at(1400, 300);

    private final List<Point2D> sent = new ArrayList<>();
    private final HiddenPointer pointer = new HiddenPointer(sent::add, START, new Rectangle2D(1000, 0, 800, 600));

    private static Point2D at(double x, double y) {
        return new Point2D(x, y);
    }

    @Test
    void inTheMiddleOfTheScreenItIsLeftWhereItIs() {
        assertThat(pointer.movedTo(at(1310, 195))).isEqualTo(at(10, -5));
        assertThat(pointer.movedTo(at(1600, 195))).isEqualTo(at(290, 0));
        pointer.release();
        assertThat(sent).isEmpty();
    }

    @Test
    void nearAnEdgeItIsSentToTheMiddleAndAtTheEndBack() {
        assertThat(pointer.movedTo(at(1001, 200))).isEqualTo(at(-299, 0));
        assertThat(sent).containsExactly(MIDDLE);
        assertThat(pointer.movedTo(MIDDLE)).isEqualTo(Point2D.ZERO);
        assertThat(pointer.movedTo(at(1350, 310))).isEqualTo(at(-50, 10));
        pointer.release();
        assertThat(sent).containsExactly(MIDDLE, START);
    }

    @Test
    void whatItDidBeforeItWasThereIsNotLost() {
        pointer.movedTo(at(1001, 200));
        assertThat(pointer.movedTo(at(1000, 203))).isEqualTo(at(-1, 3));
        // The event at the middle itself may not be told.
        assertThat(pointer.movedTo(at(1396, 302))).isEqualTo(at(-4, 2));
        assertThat(sent).containsExactly(MIDDLE);
    }

    @Test
    void itGoesRoundAgainAndAgain() {
        double right = 0;
        for (int i = 0; i < 10; i++) {
            right += pointer.movedTo(at(1799, 300)).getX();
            right += pointer.movedTo(MIDDLE).getX();
        }
        assertThat(right).isEqualTo(1799 - 1300 + 9 * 399);
        assertThat(sent).hasSize(10);
    }

    @Test
    void whereItCannotBeSentItStopsAtTheEdge() {
        pointer.movedTo(at(1001, 200));
        assertThat(pointer.movedTo(at(1000, 200))).isEqualTo(at(-1, 0));
        assertThat(pointer.movedTo(at(1000, 200))).isEqualTo(Point2D.ZERO);
        assertThat(pointer.movedTo(at(1010, 200))).isEqualTo(at(10, 0));
        assertThat(sent).containsExactly(MIDDLE);
    }
}
