///usr/bin/env jbang "$0" "$@" ; exit $?
//JAVA 25
//DEPS dev.twister:twister:0.1.0-SNAPSHOT

import dev.twister.Twister;
import dev.twister.SceneBuilder;
import dev.twister.scene.Camera;
import dev.twister.scene.Rgb;
import dev.twister.scene.Sphere;
import dev.twister.scene.Vector3;
import java.nio.file.Path;

/** A row of balls from dull to mirror, in the file that is named. */
void main(String[] arguments) throws Exception {
    SceneBuilder scene = new SceneBuilder().camera(Camera.of(new Vector3(0, 2.5, -9), 0, 12, 45));
    for (int i = 0; i < 5; i++) {
        scene.sphere(Sphere.of(new Vector3(2.2 * (i - 2), 1, 0), 1, new Rgb(0.9, 0.2 + 0.15 * i, 0.2), 32 * i));
    }
    Twister.render(scene).writePng(Path.of(arguments.length > 0 ? arguments[0] : "row.png"));
}
