// Renders a picture: jshell --class-path 'target/twister.jar:target/lib/*' examples/jshell/balls.jsh
import dev.twister.*;
import dev.twister.scene.*;

Material gold = Material.DEFAULT.withColor(new Rgb(1, 0.71, 0.29)).withReflectivity(90).withMetallic(1);
SceneBuilder scene = new SceneBuilder();
scene.camera(Camera.of(new Vector3(0, 2, -7), 0, 10, 45));
scene.rendering(Rendering.DEFAULT.withSize(640, 360));
scene.sphere(Sphere.of(new Vector3(-1.2, 1, 0), 1, gold));
scene.sphere(Sphere.of(new Vector3(1.2, 1, 0), 1, new Rgb(0.2, 0.4, 0.9), 20));
Twister.render(scene).writePng(java.nio.file.Path.of("balls.png"));
/exit
