package dev.twister.mesh.gltf;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.Reading;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;

/** Makes glTF files of one triangle that is animated; numbers become accessors of floats, one buffer view each. */
public final class AnimatedGltf {
    private static final float[] TRIANGLE = {0, 0, 0, 1, 0, 0, 0, 1, 0};

    private final List<String> accessors = new ArrayList<>();
    private final List<String> views = new ArrayList<>();
    private final ByteBuffer bytes = ByteBuffer.allocate(1 << 16).order(ByteOrder.LITTLE_ENDIAN);
    private final List<String> samplers = new ArrayList<>();
    private final List<String> channels = new ArrayList<>();
    private String attributes = "\"POSITION\":" + accessor("VEC3", TRIANGLE);
    private String mesh = "";
    private String node = "";
    private String more = "";

    /** A file with a skin, a morph target and all kinds of channels. */
    public static String example() {
        AnimatedGltf gltf = new AnimatedGltf();
        int joints = gltf.accessor("VEC4", 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0);
        int weights = gltf.accessor("VEC4", 1, 0, 0, 0, 0.25f, 0.75f, 0, 0, 1, 0, 0, 0);
        int target = gltf.accessor("VEC3", 0, 0, 0, 0, 0, -2, 0, 0, 0);
        int times = gltf.accessor("SCALAR", 0, 1);
        int places = gltf.accessor("VEC3", 0, 0, 0, 0, 4, 0);
        int turns = gltf.accessor("VEC4", 0, 0, 0, 1, 0, 0, 1, 0);
        int spline = gltf.accessor("VEC3", 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0);
        int morph = gltf.normalized("SCALAR", 2, 0, 127);
        return gltf.attributes(",\"JOINTS_0\":" + joints + ",\"WEIGHTS_0\":" + weights)
                .primitive(",\"targets\":[{\"POSITION\":" + target + "}]")
                .node(",\"skin\":0")
                .nodes(",{\"scale\":[1,2,1]},{}")
                .channel(2, "translation", "LINEAR", times, places)
                .channel(1, "rotation", "STEP", times, turns)
                .channel(1, "scale", "CUBICSPLINE", times, spline)
                .channel(0, "weights", "LINEAR", times, morph)
                .text(",\"skins\":[{\"joints\":[1,2]}]");
    }

    /** Adds an accessor; returns its number. */
    public int accessor(String type, float... values) {
        views.add("{\"buffer\":0,\"byteOffset\":" + bytes.position() + ",\"byteLength\":" + 4 * values.length + "}");
        for (float value : values) {
            bytes.putFloat(value);
        }
        int components = switch (type) {
            case "SCALAR" -> 1;
            case "VEC3" -> 3;
            case "VEC4" -> 4;
            default -> 16;
        };
        accessors.add("{\"bufferView\":" + (views.size() - 1) + ",\"componentType\":5126,\"type\":\"" + type
                + "\",\"count\":" + values.length / components + "}");
        return accessors.size() - 1;
    }

    /** Adds an accessor of normalized signed bytes. */
    public int normalized(String type, int count, int... values) {
        views.add("{\"buffer\":0,\"byteOffset\":" + bytes.position() + ",\"byteLength\":" + values.length + "}");
        for (int value : values) {
            bytes.put((byte) value);
        }
        accessors.add("{\"bufferView\":" + (views.size() - 1)
                + ",\"componentType\":5120,\"normalized\":true,\"type\":\"" + type + "\",\"count\":" + count + "}");
        return accessors.size() - 1;
    }

    /** Adds what a track of a property says. */
    public AnimatedGltf channel(int animated, String path, String interpolation, int times, int values) {
        channels.add("{\"sampler\":" + samplers.size() + ",\"target\":{\"node\":" + animated + ",\"path\":\"" + path
                + "\"}}");
        samplers.add("{\"input\":" + times + ",\"output\":" + values + ",\"interpolation\":\"" + interpolation + "\"}");
        return this;
    }

    public AnimatedGltf attributes(String text) {
        attributes += text;
        return this;
    }

    /** Fields of the primitive. */
    public AnimatedGltf primitive(String text) {
        mesh += text;
        return this;
    }

    /** Fields of the node that has the mesh, number 0. */
    public AnimatedGltf node(String text) {
        node += text;
        return this;
    }

    /** Further nodes, which are in the scene. */
    public AnimatedGltf nodes(String text) {
        more += text;
        return this;
    }

    /** The file's text, with fields of the file at its end. */
    public String text(String rest) {
        int count = 1 + (int) more.chars().filter(point -> point == '{').count();
        StringBuilder roots = new StringBuilder("0");
        for (int i = 1; i < count; i++) {
            roots.append(',').append(i);
        }
        return "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[" + roots + "]}],\"nodes\":[{\"mesh\":0" + node
                + "}" + more + "],\"meshes\":[{\"primitives\":[{\"attributes\":{" + attributes + "}" + mesh
                + "}]}],\"animations\":[{\"name\":\"move\",\"channels\":[" + String.join(",", channels)
                + "],\"samplers\":[" + String.join(",", samplers) + "]}],\"accessors\":["
                + String.join(",", accessors) + "],\"bufferViews\":[" + String.join(",", views)
                + "],\"buffers\":[{\"byteLength\":" + bytes.position() + ",\"uri\":\"data:;base64,"
                + Base64.getEncoder().encodeToString(Arrays.copyOf(bytes.array(), bytes.position()))
                + "\"}]" + rest + "}";
    }

    public MeshFile read(Path folder, List<String> warnings, String rest) {
        return Reading.read(folder, "a.gltf", text(rest).getBytes(StandardCharsets.UTF_8), 0, warnings);
    }
}
