import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.List;

/** Exercise of lesson 4, solved. */
final class LightSolution {
    private LightSolution() {}

    /** Small lights in the middle of the cells of a grid over a level rectangle. */
    static List<Light> lamp(Vector3 center, double width, double depth, int across, int along) {
        List<Light> lights = new ArrayList<>();
        for (int column = 0; column < across; column++) {
            for (int row = 0; row < along; row++) {
                double x = ((column + 0.5) / across - 0.5) * width;
                double z = ((row + 0.5) / along - 0.5) * depth;
                lights.add(Light.of(center.plus(new Vector3(x, 0, z)), 0.02, new Rgb(1, 1, 1))
                        .withShare(1d / (across * along)));
            }
        }
        return lights;
    }
}
