package dev.twister.mesh.gltf;

import dev.twister.mesh.Affine;
import dev.twister.mesh.FileSurroundings;
import dev.twister.mesh.FileSurroundings.FileCamera;
import dev.twister.mesh.FileSurroundings.FileLight;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Camera;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.scene.light.LightShape;
import dev.twister.scene.property.CameraProperties;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The lights and cameras of a glTF file's nodes. */
final class GltfSurroundings {
    static final String LIGHTS = "KHR_lights_punctual";

    /** Sine of a camera's roll that is seen. */
    private static final double ROLL = 0.01;

    /** Of the Earth's sun, as the format's lights have no size. */
    private static final double SUN_DEGREES = 0.53;

    /** Half the angle of a spot's narrowest cone, in radians. */
    private static final double LEAST_CONE = 0.001;

    private static final Vector3 AHEAD = new Vector3(0, 0, 1);
    private static final Vector3 ACROSS = new Vector3(1, 0, 0);

    private final GltfPlace root;
    private final Warnings warnings;
    private final List<FileLight> lights = new ArrayList<>();
    private final Map<String, FileCamera> cameras = new LinkedHashMap<>();
    private final List<Integer> lightNodes = new ArrayList<>();
    private final List<Integer> cameraNodes = new ArrayList<>();

    /**
     * What moves lights and cameras.
     *
     * @param lights the node of each light
     * @param cameras the node of each camera
     */
    record Carriers(List<Integer> lights, List<Integer> cameras) {
        Carriers {
            lights = List.copyOf(lights);
            cameras = List.copyOf(cameras);
        }

        /** The lights and cameras where their nodes are; those of a node that is flat, or far too large, rest. */
        FileSurroundings placed(FileSurroundings rest, Map<Integer, Affine> placements) {
            List<FileLight> movedLights = new ArrayList<>();
            for (int i = 0; i < lights.size(); i++) {
                Affine placement = GltfTransform.turned(placements.get(lights.get(i)));
                FileLight light = rest.lights().get(i);
                movedLights.add(isUsable(placement) ? light.at(placement.origin(), direction(placement)) : light);
            }
            List<FileCamera> movedCameras = new ArrayList<>();
            for (int i = 0; i < cameras.size(); i++) {
                Affine placement = GltfTransform.turned(placements.get(cameras.get(i)));
                FileCamera camera = rest.cameras().get(i);
                movedCameras.add(isUsable(placement) ? camera.at(placement.origin(), direction(placement)) : camera);
            }
            return new FileSurroundings(movedLights, movedCameras);
        }
    }

    GltfSurroundings(GltfPlace root, Warnings warnings) {
        this.root = root;
        this.warnings = warnings;
    }

    FileSurroundings all() {
        return new FileSurroundings(lights, List.copyOf(cameras.values()));
    }

    Carriers carriers() {
        return new Carriers(lightNodes, cameraNodes);
    }

    private static boolean isUsable(Affine placement) {
        return MeshLimits.isCoordinate(placement.origin().length())
                && placement.direction(AHEAD).length() > 0;
    }

    private static Vector3 direction(Affine placement) {
        return placement.direction(AHEAD).normalized();
    }

    /**
     * Adds the light and the camera of a node, if it has one.
     *
     * @param number of the node
     * @param placement transform to the file's coordinates, in Twister's axes
     */
    void add(GltfPlace node, int number, Affine placement) {
        GltfPlace light = node.at("extensions").at(LIGHTS).at("light");
        GltfPlace camera = node.at("camera");
        if (!light.exists() && !camera.exists()) {
            return;
        }
        if (!isUsable(placement)) {
            warnings.add(node + " is flat, or far too large; not read");
            return;
        }
        if (light.exists()) {
            addLight(light, placement.origin(), direction(placement));
        }
        if (camera.exists()) {
            addCamera(node, placement);
        }
        addNumbers(number, lightNodes, lights.size());
        addNumbers(number, cameraNodes, cameras.size());
    }

    /** Adds a node's number if something of it was added. */
    private static void addNumbers(int node, List<Integer> nodes, int count) {
        if (nodes.size() < count) {
            nodes.add(node);
        }
    }

    private void addLight(GltfPlace number, Vector3 position, Vector3 direction) {
        GltfPlace light = number.in(root.at("extensions").at(LIGHTS).at("lights"));
        double[] color = light.at("color").numbersOr(1, 1, 1);
        double intensity = light.at("intensity").numberOr(1);
        Rgb used = new Rgb(GltfMaterials.unit(color[0]), GltfMaterials.unit(color[1]), GltfMaterials.unit(color[2]));
        if (!(intensity > 0) || used.equals(new Rgb(0, 0, 0))) {
            return;
        }
        String type = light.at("type").text();
        if (lights.size() == SceneLimits.MAX_LIGHTS) {
            warnings.add("there are more than " + SceneLimits.MAX_LIGHTS + " lights; the others are not read");
            return;
        }
        LightShape shape = switch (type) {
            case "point" -> LightShape.SPHERE;
            case "spot" -> cone(light.at("spot"));
            case "directional" -> LightShape.SUN.withAngularDiameterDegrees(SUN_DEGREES);
            default ->
                throw light.at("type").failure("is " + QuotedText.text(type) + "; expected directional, point or spot");
        };
        lights.add(new FileLight(shape.withDirection(direction), used, intensity, position));
    }

    private static LightShape cone(GltfPlace spot) {
        double outer = Math.clamp(spot.at("outerConeAngle").numberOr(Math.PI / 4), LEAST_CONE, Math.PI / 2);
        double inner = Math.clamp(spot.at("innerConeAngle").numberOr(0), 0, outer);
        return LightShape.SPOT.withConeAngleDegrees(Math.toDegrees(2 * outer)).withConeBlend(1 - inner / outer);
    }

    private void addCamera(GltfPlace node, Affine placement) {
        GltfPlace camera = node.at("camera").in(root.at("cameras"));
        if (cameras.size() == SceneLimits.MAX_VIEWS) {
            warnings.add("there are more than " + SceneLimits.MAX_VIEWS + " cameras; the others are not read");
            return;
        }
        if (Math.abs(placement.direction(ACROSS).normalized().y()) > ROLL) {
            warnings.add(camera + " is rolled; its view is level");
        }
        String name = name(node.at("name").textOr(camera.at("name").textOr("")));
        cameras.put(name, new FileCamera(name, lens(camera), placement.origin(), direction(placement)));
    }

    /** A camera at the origin with the field of view, or what is seen without perspective. */
    private static Camera lens(GltfPlace camera) {
        GltfPlace perspective = camera.at("perspective");
        if (!perspective.exists()) {
            double half = Math.abs(camera.at("orthographic").at("ymag").number());
            return Camera.DEFAULT
                    .withProjection(Camera.Projection.ORTHOGRAPHIC)
                    .withViewHeight(CameraProperties.VIEW_HEIGHT.range().clamp(2 * half));
        }
        double height = Math.tan(Math.clamp(perspective.at("yfov").number(), 0, Math.PI) / 2);
        double width = height * Math.max(0, perspective.at("aspectRatio").numberOr(1));
        double angle = Math.toDegrees(2 * Math.atan(Math.min(height, width)));
        return Camera.DEFAULT.withFieldOfViewDegrees(
                CameraProperties.fieldOfView(Camera.Projection.PERSPECTIVE).clamp(angle));
    }

    /** A name that no other camera has. */
    private String name(String wanted) {
        String plain = wanted.codePoints()
                .filter(point -> !Character.isISOControl(point))
                .limit(SceneLimits.MAX_NAME_LENGTH / 2)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString()
                .strip();
        String stem = plain.isEmpty() ? "camera" : plain;
        String name = stem;
        for (int number = 2; cameras.containsKey(name); number++) {
            name = stem + " " + number;
        }
        return name;
    }
}
