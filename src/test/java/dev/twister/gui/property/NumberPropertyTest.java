package dev.twister.gui.property;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.twister.gui.edit.BodyMaterials;
import dev.twister.gui.edit.Scenes;
import dev.twister.kernel.Layout;
import dev.twister.scene.Scene;
import dev.twister.scene.property.BodyProperties;
import dev.twister.scene.property.Property;
import dev.twister.scene.property.SceneProperties;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class NumberPropertyTest {
    private static final NumberProperty<Scene> SHADOW_SAMPLES = PropertyNumbers.of(
                    SceneProperties.SHADOW_SAMPLES.within(Scene::rendering, Scene::withRendering))
            .getFirst();

    private final Scene scene = Scenes.scene();

    static Stream<NumberProperty<Scene>> all() {
        int body = Layout.FIRST_SPHERE + 1;
        Scene scene = Scenes.scene();
        Stream<NumberProperty<Scene>> materials = Stream.of(body, Layout.PLANE)
                .flatMap(of -> PanelNumbers.ofMaterial().stream()
                        .map(number -> number.in(
                                whole -> BodyMaterials.of(whole, of),
                                (whole, edit) -> BodyMaterials.edited(whole, of, edit))));
        return Stream.of(
                        PropertyNumbers.of(
                                Property.within(SceneProperties.RENDERING, Scene::rendering, Scene::withRendering))
                                .stream(),
                        PanelNumbers.ofCamera().stream(),
                        PanelNumbers.ofLight(0).stream(),
                        PropertyNumbers.of(Property.within(SceneProperties.SKY, Scene::sky, Scene::withSky)).stream(),
                        PropertyNumbers.of(Property.within(SceneProperties.SHADING, Scene::shading, Scene::withShading))
                                .stream(),
                        PropertyNumbers.of(Property.within(BodyProperties.PLANE, Scene::ground, Scene::withGround))
                                .stream(),
                        PropertyNumbers.of(Property.within(SceneProperties.PHYSICS, Scene::physics, Scene::withPhysics))
                                .stream(),
                        PropertyNumbers.ofBody(scene, body).stream(),
                        materials)
                .flatMap(numbers -> numbers);
    }

    @ParameterizedTest
    @MethodSource("all")
    void whatIsWrittenIsRead(NumberProperty<Scene> setting) {
        for (double place : new double[] {0, 0.3, 1}) {
            double number = setting.scale().numberAt(place);
            assertThat(setting.read(setting.write(scene, number))).isCloseTo(number, within(1e-9));
            assertThat(setting.scale().allowed().contains(number)).isTrue();
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void nothingElseIsWritten(NumberProperty<Scene> setting) {
        double before = setting.read(scene);
        Scene there = setting.write(scene, setting.scale().around(before).numberAt(0.9));
        assertThat(there).isNotEqualTo(scene);
        assertThat(setting.write(there, before)).isEqualTo(scene);
    }

    @ParameterizedTest
    @MethodSource("all")
    void arrowKeysMoveAndComeToTheEnds(NumberProperty<Scene> setting) {
        double number = setting.scale().slid().min();
        int steps = 0;
        while (number < setting.scale().slid().max() && steps < 1000) {
            double next = setting.scale().stepped(number, 1);
            assertThat(next).isGreaterThan(number);
            number = next;
            steps++;
        }
        assertThat(number).isEqualTo(setting.scale().slid().max());
        assertThat(setting.scale().stepped(number, 1)).isEqualTo(number);
        assertThat(setting.scale().stepped(number, -1)).isLessThan(number);
        assertThat(setting.scale().stepped(setting.scale().slid().min(), -1))
                .isEqualTo(setting.scale().slid().min());
    }

    @ParameterizedTest
    @MethodSource("all")
    void whatIsShownIsUnderstood(NumberProperty<Scene> setting) {
        double number = setting.scale().numberAt(0.37);
        assertThat(setting.scale().parse(setting.scale().text(number))).contains(number);
    }

    @Test
    void whatIsTypedIsCheckedAgainstTheScenesLimits() {
        assertThat(SHADOW_SAMPLES.scale().parse(" 700 ")).contains(700.0);
        assertThat(SHADOW_SAMPLES.scale().parse("0")).isEmpty();
        assertThat(SHADOW_SAMPLES.scale().parse("1025")).isEmpty();
        assertThat(SHADOW_SAMPLES.scale().parse("many")).isEmpty();
        assertThat(SHADOW_SAMPLES.scale().parse("NaN")).isEmpty();
        assertThat(SHADOW_SAMPLES.scale().parse("")).isEmpty();
        assertThat(SHADOW_SAMPLES.scale().parse("1e999999999")).isEmpty();
        assertThat(PropertyNumbers.EXPOSURE.scale().parse("-0,5")).contains(-0.5);
        assertThat(SHADOW_SAMPLES.complaint("many"))
                .isEqualTo("Shadow samples is 'many', but must be a number from 1 to 1024");
    }

    @Test
    void arrowKeysDoNotTakeBackWhatIsBeyondTheSlider() {
        assertThat(PropertyNumbers.EXPOSURE.scale().stepped(12, 1)).isEqualTo(12);
        assertThat(PropertyNumbers.EXPOSURE.scale().stepped(12, -1)).isLessThan(12);
        assertThat(PropertyNumbers.EXPOSURE.scale().stepped(-12, -1)).isEqualTo(-12);
    }

    @Test
    void placesFollowTheScale() {
        assertThat(SHADOW_SAMPLES.scale().placeOf(20)).isCloseTo(0.5, within(1e-9));
        assertThat(SHADOW_SAMPLES.scale().numberAt(0.5)).isEqualTo(20);
        assertThat(SHADOW_SAMPLES.scale().placeOf(1000)).isEqualTo(1);
        assertThat(PropertyNumbers.EXPOSURE.scale().placeOf(0)).isEqualTo(0.5);
    }

    @Test
    void aPlacesSliderIsAboutWhereTheBodyIs() {
        NumberScale near = PanelNumbers.ofLight(0).get(0).scale().around(50);
        assertThat(near.placeOf(50)).isEqualTo(0.5);
        assertThat(near.numberAt(1)).isEqualTo(55);
        assertThat(PanelNumbers.ofLight(0).get(0).scale().around(1e6).numberAt(1))
                .isEqualTo(1e6);
        assertThat(PropertyNumbers.EXPOSURE.scale().around(3)).isEqualTo(PropertyNumbers.EXPOSURE.scale());
    }

    @Test
    void aSmallSizeIsShownWithItsDigits() {
        NumberProperty<Scene> radius = light("Light size");
        assertThat(radius.scale().text(0.004)).isEqualTo("0.004");
        assertThat(radius.scale().text(0.0123456)).isEqualTo("0.012");
        assertThat(radius.scale().text(1e-6)).isEqualTo("0.000001");
        assertThat(radius.scale().text(1.234)).isEqualTo("1.23");
        assertThat(PanelNumbers.ofLight(0).get(0).scale().text(1e-9)).isEqualTo("0");
        assertThat(radius.scale().parse(radius.scale().text(0.004))).contains(0.004);
    }

    @Test
    void aDragGoesBeyondTheSliderUpToWhatIsAllowed() {
        assertThat(PropertyNumbers.EXPOSURE.scale().movedBy(6, 0.5)).isEqualTo(12);
        assertThat(SHADOW_SAMPLES.scale().movedBy(400, 1)).isEqualTo(1024);
        assertThat(SHADOW_SAMPLES.scale().movedBy(20, 0.5)).isCloseTo(400, within(1e-6));
        assertThat(light("Light brightness").scale().movedBy(0, 0.1)).isPositive();
    }

    @Test
    void aLightThatIsOutCanBeLitAgain() {
        Scene out = light("Light brightness").write(scene, 0);
        Scene lit = light("Light brightness").write(out, 3);
        assertThat(light("Light brightness").read(lit)).isEqualTo(3);
    }

    private static NumberProperty<Scene> light(String label) {
        return PanelNumbers.ofLight(0, label);
    }
}
