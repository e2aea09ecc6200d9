package dev.twister;

import static java.util.Objects.requireNonNull;

import dev.twister.mesh.MeshException;
import dev.twister.scene.Camera;
import dev.twister.scene.Ground;
import dev.twister.scene.Light;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Rgb;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Shading;
import dev.twister.scene.Sphere;
import dev.twister.scene.Track;
import dev.twister.scene.light.Lights;
import dev.twister.scene.property.SceneLimits;
import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.world.SceneImages;
import dev.twister.world.SceneMeshes;
import dev.twister.world.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Makes a scene in code, without any file. What is not set is as in a scene file that leaves it out; the sky is light
 * gray. Used by one thread.
 */
public final class SceneBuilder {
    private final List<Sphere> spheres = new ArrayList<>();
    private final List<Mesh> meshes = new ArrayList<>();
    private final List<Track> tracks = new ArrayList<>();
    // The file's name is never read: the sky is here.
    private Scene scene = Scene.under(Path.of("sky"));
    private Skybox sky = uniform(new Rgb(0.8, 0.8, 0.8));

    public SceneBuilder camera(Camera camera) {
        scene = scene.withCamera(requireNonNull(camera, "camera"));
        return this;
    }

    /** The only light. */
    public SceneBuilder light(Light light) {
        return lights(List.of(requireNonNull(light, "light")));
    }

    /**
     * All lights.
     *
     * @throws IllegalArgumentException unless there are 1 to {@value SceneLimits#MAX_LIGHTS}
     */
    public SceneBuilder lights(List<Light> lights) {
        scene = scene.withLights(new Lights(requireNonNull(lights, "lights")));
        return this;
    }

    public SceneBuilder ground(Ground ground) {
        scene = scene.withGround(requireNonNull(ground, "ground"));
        return this;
    }

    /** Adds a sphere. */
    public SceneBuilder sphere(Sphere sphere) {
        spheres.add(requireNonNull(sphere, "sphere"));
        return this;
    }

    /**
     * Adds triangles: those of a file, of a {@link dev.twister.scene.Shape}, or {@link dev.twister.scene.Triangles}, by
     * {@link Mesh#of}.
     */
    public SceneBuilder mesh(Mesh mesh) {
        meshes.add(requireNonNull(mesh, "mesh"));
        return this;
    }

    /** Adds a track, which changes a property in a film: see {@link dev.twister.world.Animation}. */
    public SceneBuilder track(Track track) {
        tracks.add(requireNonNull(track, "track"));
        return this;
    }

    /**
     * A sky of one color, as linear radiance.
     *
     * @throws SceneException where a channel is not from 0 to 1,000,000
     */
    public SceneBuilder sky(Rgb color) {
        SceneLimits.RADIANCE.require("sky.red", color.red());
        SceneLimits.RADIANCE.require("sky.green", color.green());
        SceneLimits.RADIANCE.require("sky.blue", color.blue());
        return sky(uniform(color));
    }

    /** A panorama, such as one of {@link dev.twister.sky.DaylightSky}. */
    public SceneBuilder sky(Skybox panorama) {
        sky = requireNonNull(panorama, "panorama");
        return this;
    }

    /** The ambient strength, 0 to 1; {@value Shading#DEFAULT_AMBIENT} where it is not set. */
    public SceneBuilder ambient(double ambient) {
        scene = scene.withShading(new Shading(ambient));
        return this;
    }

    public SceneBuilder rendering(Rendering rendering) {
        scene = scene.withRendering(requireNonNull(rendering, "rendering"));
        return this;
    }

    /** The scene, whose sky has no file; {@code Animation.at} tells what it is at a time of its film. */
    public Scene scene() {
        return scene.withSpheres(spheres).withMeshes(meshes).withTracks(tracks);
    }

    /**
     * The world at the start; meshes and textures are read from their files.
     *
     * @throws SceneException where a value is out of range; the message names it and its range
     * @throws SkyException where a texture cannot be read
     * @throws MeshException where a mesh cannot be read
     */
    public World world() {
        Scene whole = scene();
        SceneCheck.check(whole);
        SceneMeshes read = SceneMeshes.read(whole, _ -> {});
        return World.of(whole, SceneImages.read(whole, sky, read, _ -> {}), read);
    }

    private static Skybox uniform(Rgb color) {
        return new Skybox(1, 1, new float[] {(float) color.red(), (float) color.green(), (float) color.blue()});
    }
}
