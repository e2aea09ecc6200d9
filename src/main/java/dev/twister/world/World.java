package dev.twister.world;

import static java.util.Objects.requireNonNull;

import dev.twister.kernel.Layout;
import dev.twister.kernel.Views;
import dev.twister.scene.Camera;
import dev.twister.scene.Integrator;
import dev.twister.scene.Mesh;
import dev.twister.scene.Rendering;
import dev.twister.scene.Scene;
import dev.twister.scene.SceneException;
import dev.twister.scene.Vector3;
import dev.twister.sky.Skybox;
import dev.twister.world.table.EmitterTable;
import dev.twister.world.table.Emitters;
import dev.twister.world.table.LookTable;
import dev.twister.world.table.MeshBody;
import dev.twister.world.table.PlaceTable;
import dev.twister.world.table.TwinTable;

/** The mutable state between frames, initialized from a scene. For use by one thread; engines get snapshots. */
public final class World {
    private static final double DEGREES_PER_TURN = 360;

    private final Vector3 origin;
    private final PlaceTable places;
    private final LookTable looks = new LookTable();
    private final TwinTable twins = new TwinTable();
    private final EmitterTable emitters = new EmitterTable();
    private Scene scene;
    private SceneImages images;
    private SceneMeshes meshes;
    private boolean moved;
    private float[] shadowDisc;
    private float[] pixelSamples;

    private World(Scene scene, SceneImages images, SceneMeshes meshes) {
        origin = originOf(scene);
        places = new PlaceTable(origin);
        this.scene = scene;
        this.images = images;
        this.meshes = meshes.posed(scene.meshes(), meshes);
        putPlaces();
        putLooks();
        shadowDisc = SunflowerDisc.points(scene.rendering().shadowSamples());
        pixelSamples = PixelSamples.of(scene.rendering().samplesPerPixel());
    }

    /** The world at the start, before any sphere is poured. */
    public static World of(Scene scene, Skybox sky) {
        return of(scene, SceneImages.of(sky));
    }

    /** As above, for a scene with textures. */
    public static World of(Scene scene, SceneImages images) {
        return of(scene, images, SceneMeshes.NONE);
    }

    /**
     * As above, for a scene with meshes.
     *
     * @throws IllegalArgumentException if one of the scene's textures or meshes is missing
     */
    public static World of(Scene scene, SceneImages images, SceneMeshes meshes) {
        return new World(scene, images, meshes);
    }

    /** The {@link #origin} of every world of a scene. */
    public static Vector3 originOf(Scene scene) {
        return Origin.near(scene.camera().position());
    }

    /** Origin of the snapshots' coordinates, in the scene's coordinates; near the scene's camera. */
    public Vector3 origin() {
        return origin;
    }

    /**
     * Whether the origin is near enough to a camera; otherwise a new world of the scene gives a more accurate picture.
     */
    public boolean isNear(Camera other) {
        return Origin.isNear(origin, other.position());
    }

    /** The images of this world. */
    public SceneImages images() {
        return images;
    }

    /** The meshes of this world. */
    public SceneMeshes meshes() {
        return meshes;
    }

    /**
     * Shows another scene, or the same one with edits, as a new world would, but for the origin. Only what depends on
     * records that have changed is built again. Bodies that were moved stay where they are, unless the scene's bodies
     * have changed.
     *
     * @throws IllegalArgumentException if one of the scene's textures or meshes is missing
     */
    @SuppressWarnings("ReferenceEquality")
    public void show(Scene newScene, SceneImages newImages, SceneMeshes newMeshes) {
        Scene before = scene;
        SceneMeshes posed = newMeshes.posed(newScene.meshes(), meshes);
        boolean sameBodies = hasBodiesOf(newScene)
                && newScene.lights().count() == before.lights().count()
                && newScene.lights().first().isSun() == before.lights().first().isSun()
                && meshes.equals(posed);
        boolean sameLooks = sameBodies && hasSurfacesOf(newScene) && images.equals(newImages);
        scene = newScene;
        images = newImages;
        meshes = posed;
        if (!sameBodies) {
            putPlaces();
        } else {
            if (scene.lights() != before.lights() || changesIntegrator(before)) {
                places.put(scene.lights(), scene.rendering().integrator());
            }
            if (scene.ground() != before.ground()) {
                places.put(scene.ground());
            }
        }
        if (!sameLooks) {
            putLooks();
        } else if (scene.lights() != before.lights()) {
            looks.put(scene.lights());
        }
        putSamples(before.rendering());
    }

    /** As above, with the images and meshes of this world. */
    public void show(Scene newScene) {
        show(newScene, images, meshes);
    }

    private boolean changesIntegrator(Scene before) {
        return scene.rendering().integrator() != before.rendering().integrator();
    }

    /** Whether another scene has the same materials on the same bodies, so that it needs no other images. */
    @SuppressWarnings("ReferenceEquality") // an edit makes a new record; to compare all spheres takes longer
    public boolean hasSurfacesOf(Scene other) {
        return hasBodiesOf(other) && other.ground().material() == scene.ground().material();
    }

    @SuppressWarnings("ReferenceEquality")
    private boolean hasBodiesOf(Scene other) {
        return other.spheres() == scene.spheres()
                && other.meshes().equals(scene.meshes())
                && other.pour().equals(scene.pour());
    }

    /** Puts all bodies where the scene has them. */
    public void resetBodies() {
        putPlaces();
    }

    /** Whether bodies are where {@link #setBodyPositions} has put them. */
    public boolean isMoved() {
        return moved;
    }

    private void putPlaces() {
        moved = false;
        places.put(
                scene.lights(),
                scene.rendering().integrator(),
                scene.ground(),
                scene.allSpheres(),
                Layout.FIRST_SPHERE + scene.spheres().size(),
                MeshBody.of(scene, meshes, origin),
                meshes.floats());
    }

    private void putLooks() {
        looks.put(
                scene.lights(),
                scene.ground(),
                scene.allSpheres(),
                MeshBody.of(scene, meshes, origin),
                meshes.floats(),
                images);
    }

    private void putSamples(Rendering before) {
        Rendering now = scene.rendering();
        if (now.shadowSamples() != before.shadowSamples()) {
            shadowDisc = SunflowerDisc.points(now.shadowSamples());
        }
        if (now.samplesPerPixel() != before.samplesPerPixel()) {
            pixelSamples = PixelSamples.of(now.samplesPerPixel());
        }
    }

    /** The scene that is shown, with the camera and the settings as they are now; bodies are where it began. */
    public Scene scene() {
        return scene;
    }

    /**
     * Moves, turns or scales a mesh. Spheres that were moved go back to where the scene has them.
     *
     * @param index of the mesh in the scene, from 0
     * @param mesh has the triangles and the material that it had
     * @throws IllegalArgumentException if its triangles are others
     */
    public void setMesh(int index, Mesh mesh) {
        if (!mesh.geometry().equals(scene.meshes().get(index).geometry())) {
            throw new IllegalArgumentException("mesh " + index + " is "
                    + scene.meshes().get(index).geometry().name() + ", but the new one is "
                    + mesh.geometry().name());
        }
        show(scene.withBodies(scene.bodies().withMesh(index, mesh)));
    }

    public Camera camera() {
        return scene.camera();
    }

    /**
     * Sets the camera of the next snapshots.
     *
     * @throws SceneException if a value is out of range; the message names it
     */
    public void setCamera(Camera newCamera) {
        requireNonNull(newCamera, "camera").requireInRange();
        scene = scene.withCamera(newCamera);
    }

    public Rendering settings() {
        return scene.rendering();
    }

    /**
     * Sets size and quality of the next snapshots.
     *
     * @throws SceneException if a value is out of range; the message names it
     */
    public void setSettings(Rendering newSettings) {
        requireNonNull(newSettings, "settings").requireInRange();
        Rendering before = scene.rendering();
        Scene old = scene;
        scene = scene.withRendering(newSettings);
        if (changesIntegrator(old)) {
            placeLights();
        }
        putSamples(before);
    }

    /**
     * Moves the bodies, except meshes and lights after the first.
     *
     * @param positions {@code float[3 * room]}: the centers of the first light, the plane and all spheres, including
     *     those not poured yet, relative to the {@link #origin}, in meters
     * @param newBodies number of present bodies, including light and plane
     * @throws IllegalArgumentException if the length is wrong, or there is no room for that number of bodies
     */
    public void setBodyPositions(float[] positions, int newBodies) {
        places.move(positions, newBodies);
        moved = true;
    }

    /** Puts the lights where the scene has them, after {@link #setBodyPositions} has put the first elsewhere. */
    public void placeLights() {
        places.put(scene.lights(), scene.rendering().integrator());
    }

    /**
     * The current state as an engine's input for the whole picture. If spheres have changed, moved or been poured since
     * the last snapshot, the hierarchy over them is rebuilt.
     */
    public FrameInput snapshot() {
        Bodies bodies = new Bodies(
                places.floats(),
                looks.looks(),
                looks.meshes(),
                places.numbers().room(),
                places.numbers().firstMesh(),
                places.end(),
                places.firstMesh(),
                looks.materials()
                        | twins.variant(
                                places.floats(), looks.looks(), places.numbers().room(), places.present()),
                origin,
                places.hierarchy());
        float[] values = values(bodies);
        Bodies shown = bodies;
        float[] shownImages = looks.texels();
        if (scene.rendering().integrator() == Integrator.PATH) {
            Emitters tables = emitters.of(
                    bodies,
                    places.present(),
                    scene.meshes(),
                    LightStrength.radiances(scene.lights(), scene.ground()),
                    looks.texels(),
                    images.sky(),
                    scene.sky().strength() > 0);
            tables.write(values);
            shown = bodies.withLooks(tables.looks());
            shownImages = tables.images();
        }
        return new FrameInput(View.of(values, shadowDisc, pixelSamples, Views.FULL), shown, shownImages);
    }

    /** The groups of the scene's lights, for {@link FrameInput#withLightLayers}. */
    public LightGroups lightGroups() {
        return LightGroups.of(scene, MeshBody.of(scene, meshes, origin));
    }

    private float[] values(Bodies bodies) {
        Rendering settings = scene.rendering();
        float[] values = new float[Layout.SAMPLES];
        Camera seen = scene.camera().withPosition(bodies.seen(scene.camera().position()));
        System.arraycopy(CameraBasis.of(seen), 0, values, 0, Layout.CAMERA_LENGTH);
        values[Layout.SHADOW_SAMPLES] = settings.shadowSamples();
        values[Layout.BOUNCES] = settings.bounces();
        values[Layout.PIXEL_SAMPLES] = settings.samplesPerPixel();
        putTone(values, settings);
        values[Layout.AMBIENT] = (float) scene.shading().ambient();
        LookTable.putColor(values, Layout.PLANE_ODD_COLOR, scene.ground().oddColor());
        double skyTurn = scene.sky().rotationDegrees() / DEGREES_PER_TURN;
        values[Layout.SKY_TURN] = (float) (skyTurn - Math.floor(skyTurn)) % 1f;
        values[Layout.SKY_STRENGTH] = (float) scene.sky().strength();
        values[Layout.SKY_WIDTH] = images.sky().width();
        values[Layout.SKY_HEIGHT] = images.sky().height();
        values[Layout.WIDTH] = settings.width();
        values[Layout.HEIGHT] = settings.height();
        values[Layout.ROWS] = settings.height();
        values[Layout.BODIES] = places.present();
        values[Layout.FIRST_MESH] = bodies.firstMesh();
        values[Layout.ROOT] = places.root();
        values[Layout.SHADOW_ROOT] = places.shadowRoot();
        values[Layout.INSTANCES] = bodies.instances();
        values[Layout.MAPS] = bodies.textures();
        values[Layout.CLAMP] = (float) settings.clamp();
        values[Layout.LIGHTS] = scene.lights().count();
        values[Layout.LIGHT_TABLE] = looks.lightTable();
        CameraMedia.write(values, bodies, places.present());
        values[Layout.FIRST_SAMPLE] = PixelSamples.first(settings.samplesPerPixel());
        return values;
    }

    @SuppressWarnings("EnumOrdinal") // a test checks that the kernel's numbers match the constants' order
    static void putTone(float[] frame, Rendering settings) {
        frame[Layout.EXPOSURE_SCALE] = (float) Math.pow(2, settings.exposure());
        frame[Layout.TONE_MAP] = settings.toneMap().ordinal();
        frame[Layout.SRGB] = settings.srgb() ? 1 : 0;
    }

    /** Chooses the origin of a world's coordinates: floats lose precision far from it. */
    private static final class Origin {
        /** Largest distance along each axis, in meters, at which floats are still accurate to 0.25 mm. */
        private static final double NEAR = 4096;

        private Origin() {}

        /**
         * The scene's own origin if the point is near it, else the even integer point nearest to the point. Even, so
         * that the checker keeps its colors.
         */
        static Vector3 near(Vector3 place) {
            return isNear(Vector3.ZERO, place) ? Vector3.ZERO : place.map(Origin::even);
        }

        static boolean isNear(Vector3 origin, Vector3 place) {
            return Math.abs(place.x() - origin.x()) <= NEAR
                    && Math.abs(place.y() - origin.y()) <= NEAR
                    && Math.abs(place.z() - origin.z()) <= NEAR;
        }

        private static double even(double coordinate) {
            return 2 * Math.rint(coordinate / 2);
        }
    }
}
