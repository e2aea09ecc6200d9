import dev.twister.scene.Light;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import java.util.List;

/** Exercise of lesson 4: a lamp that is a rectangle. */
final class LightAttempt {
    private LightAttempt() {}

    /**
     * Small lights in the middle of the cells of a grid over a level rectangle. Together they are as bright as one
     * light.
     *
     * @param center of the rectangle
     * @param width along x, in meters
     * @param depth along z, in meters
     * @param across number of cells along x
     * @param along number of cells along z
     */
    static List<Light> lamp(Vector3 center, double width, double depth, int across, int along) {
        return List.of(Light.of(center, 0.02, new Rgb(1, 1, 1)));
    }
}
