package dev.twister.gui.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class NumberSettingTest {
    private final Scene scene = Scenes.scene();

    static Stream<NumberSetting> all() {
        int body = Layout.FIRST_SPHERE + 1;
        return Stream.of(
                SceneNumbers.SHADOW_SAMPLES,
                SceneNumbers.BOUNCES,
                SceneNumbers.SAMPLES_PER_PIXEL,
                SceneNumbers.EXPOSURE,
                SceneNumbers.FIELD_OF_VIEW,
                SceneNumbers.APERTURE,
                SceneNumbers.FOCUS_DISTANCE,
                SceneNumbers.LIGHT_X,
                SceneNumbers.LIGHT_Y,
                SceneNumbers.LIGHT_Z,
                SceneNumbers.LIGHT_RADIUS,
                SceneNumbers.LIGHT_STRENGTH,
                BodyNumbers.ofSphere(body).x(),
                BodyNumbers.ofSphere(body).y(),
                BodyNumbers.ofSphere(body).z(),
                BodyNumbers.ofSphere(body).radius(),
                MaterialNumbers.of(body).reflectivity(),
                MaterialNumbers.of(body).roughness(),
                MaterialNumbers.of(body).transmission(),
                MaterialNumbers.of(body).ior(),
                MaterialNumbers.of(Layout.PLANE).reflectivity());
    }

    @ParameterizedTest
    @MethodSource("all")
    void whatIsWrittenIsRead(NumberSetting setting) {
        for (double place : new double[] {0, 0.3, 1}) {
            double number = setting.numberAt(place);
            assertThat(setting.read(setting.write(scene, number))).isCloseTo(number, within(1e-9));
            assertThat(setting.allowed().contains(number)).isTrue();
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void nothingElseIsWritten(NumberSetting setting) {
        double before = setting.read(scene);
        Scene there = setting.write(scene, setting.around(before).numberAt(0.9));
        assertThat(there).isNotEqualTo(scene);
        assertThat(setting.write(there, before)).isEqualTo(scene);
    }

    @ParameterizedTest
    @MethodSource("all")
    void arrowKeysMoveAndComeToTheEnds(NumberSetting setting) {
        double number = setting.slid().min();
        int steps = 0;
        while (number < setting.slid().max() && steps < 1000) {
            double next = setting.stepped(number, 1);
            assertThat(next).isGreaterThan(number);
            number = next;
            steps++;
        }
        assertThat(number).isEqualTo(setting.slid().max());
        assertThat(setting.stepped(number, 1)).isEqualTo(number);
        assertThat(setting.stepped(number, -1)).isLessThan(number);
        assertThat(setting.stepped(setting.slid().min(), -1))
                .isEqualTo(setting.slid().min());
    }

    @ParameterizedTest
    @MethodSource("all")
    void whatIsShownIsUnderstood(NumberSetting setting) {
        double number = setting.numberAt(0.37);
        assertThat(setting.parse(setting.text(number))).contains(number);
    }

    @Test
    void whatIsTypedIsCheckedAgainstTheScenesLimits() {
        NumberSetting shadows = SceneNumbers.SHADOW_SAMPLES;
        assertThat(shadows.parse(" 700 ")).contains(700.0);
        assertThat(shadows.parse("0")).isEmpty();
        assertThat(shadows.parse("1025")).isEmpty();
        assertThat(shadows.parse("many")).isEmpty();
        assertThat(shadows.parse("NaN")).isEmpty();
        assertThat(shadows.parse("")).isEmpty();
        assertThat(shadows.parse("1e999999999")).isEmpty();
        assertThat(SceneNumbers.EXPOSURE.parse("-0,5")).contains(-0.5);
        assertThat(shadows.complaint("many"))
                .isEqualTo("Shadow samples is 'many', but must be a number from 1 to 1024");
    }

    @Test
    void placesFollowTheScale() {
        NumberSetting shadows = SceneNumbers.SHADOW_SAMPLES;
        assertThat(shadows.placeOf(20)).isCloseTo(0.5, within(1e-9));
        assertThat(shadows.numberAt(0.5)).isEqualTo(20);
        assertThat(shadows.placeOf(1000)).isEqualTo(1);
        assertThat(SceneNumbers.EXPOSURE.placeOf(0)).isEqualTo(0.5);
    }

    @Test
    void aPlacesSliderIsAboutWhereTheBodyIs() {
        NumberSetting near = SceneNumbers.LIGHT_X.around(50);
        assertThat(near.placeOf(50)).isEqualTo(0.5);
        assertThat(near.numberAt(1)).isEqualTo(55);
        assertThat(SceneNumbers.LIGHT_X.around(1e6).numberAt(1)).isEqualTo(1e6);
        assertThat(SceneNumbers.EXPOSURE.around(3)).isEqualTo(SceneNumbers.EXPOSURE);
    }

    @Test
    void aSmallSizeIsShownWithItsDigits() {
        NumberSetting radius = SceneNumbers.LIGHT_RADIUS;
        assertThat(radius.text(0.004)).isEqualTo("0.004");
        assertThat(radius.text(0.0123456)).isEqualTo("0.012");
        assertThat(radius.text(1e-6)).isEqualTo("0.000001");
        assertThat(radius.text(1.234)).isEqualTo("1.23");
        assertThat(SceneNumbers.LIGHT_X.text(1e-9)).isEqualTo("0");
        assertThat(radius.parse(radius.text(0.004))).contains(0.004);
    }

    @Test
    void aDragGoesBeyondTheSliderUpToWhatIsAllowed() {
        assertThat(SceneNumbers.EXPOSURE.movedBy(6, 0.5)).isEqualTo(12);
        assertThat(SceneNumbers.SHADOW_SAMPLES.movedBy(400, 1)).isEqualTo(1024);
        assertThat(SceneNumbers.SHADOW_SAMPLES.movedBy(20, 0.5)).isCloseTo(400, within(1e-6));
        assertThat(SceneNumbers.LIGHT_STRENGTH.movedBy(0, 0.1)).isPositive();
    }

    @Test
    void aLightThatIsOutCanBeLitAgain() {
        Scene out = SceneNumbers.LIGHT_STRENGTH.write(scene, 0);
        Scene lit = SceneNumbers.LIGHT_STRENGTH.write(out, 3);
        assertThat(SceneNumbers.LIGHT_STRENGTH.read(lit)).isEqualTo(3);
    }
}
