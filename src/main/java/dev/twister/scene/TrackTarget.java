package dev.twister.scene;

import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The part of a scene that a track changes.
 *
 * @param index place in the scene's list; 0 where there is one alone
 */
public record TrackTarget(Kind kind, int index) {
    /** What has animated properties. */
    public enum Kind {
        CAMERA("camera", false),
        LIGHT("lights", true),
        PLANE("plane", false),
        SPHERE("spheres", true),
        MESH("meshes", true),
        SKY("sky", false),
        SHADING("shading", false),
        RENDERING("rendering", false);

        private final String label;
        private final boolean listed;

        Kind(String label, boolean listed) {
            this.label = label;
            this.listed = listed;
        }

        /** Its field of a scene file. */
        public String label() {
            return label;
        }

        /** Whether a scene has a list of them. */
        public boolean isListed() {
            return listed;
        }
    }

    public static final TrackTarget CAMERA = new TrackTarget(Kind.CAMERA, 0);
    public static final TrackTarget PLANE = new TrackTarget(Kind.PLANE, 0);
    public static final TrackTarget SKY = new TrackTarget(Kind.SKY, 0);
    public static final TrackTarget SHADING = new TrackTarget(Kind.SHADING, 0);
    public static final TrackTarget RENDERING = new TrackTarget(Kind.RENDERING, 0);

    private static final Pattern TEXT = Pattern.compile("([a-z]+)(?:\\[(0|[1-9][0-9]{0,6})])?");

    public static TrackTarget light(int index) {
        return new TrackTarget(Kind.LIGHT, index);
    }

    public static TrackTarget sphere(int index) {
        return new TrackTarget(Kind.SPHERE, index);
    }

    public static TrackTarget mesh(int index) {
        return new TrackTarget(Kind.MESH, index);
    }

    /** The target that {@link #toString} writes so. */
    public static Optional<TrackTarget> parse(String text) {
        Matcher found = TEXT.matcher(text);
        if (!found.matches()) {
            return Optional.empty();
        }
        Optional<String> index = Optional.ofNullable(found.group(2));
        return Arrays.stream(Kind.values())
                .filter(kind -> kind.label().equals(found.group(1)) && kind.isListed() == index.isPresent())
                .findFirst()
                .map(kind -> new TrackTarget(kind, index.map(Integer::parseInt).orElse(0)));
    }

    /** How many of its kind a scene has. */
    public int count(Scene scene) {
        return switch (kind) {
            case LIGHT -> scene.lights().count();
            case SPHERE -> scene.spheres().size();
            case MESH -> scene.meshes().size();
            case CAMERA, PLANE, SKY, SHADING, RENDERING -> 1;
        };
    }

    /** Its path in a scene file, such as {@code spheres[3]} or {@code sky}. */
    @Override
    public String toString() {
        return kind.isListed() ? kind.label() + "[" + index + "]" : kind.label();
    }
}
