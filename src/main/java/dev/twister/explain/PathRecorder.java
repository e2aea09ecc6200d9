package dev.twister.explain;

import dev.twister.explain.PathStep.RayKind;
import dev.twister.explain.PathStep.ShadedSurface;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Medium;
import dev.twister.kernel.Path;
import dev.twister.kernel.PixelKernel;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.world.Bodies;
import dev.twister.world.FrameInput;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Takes the kernel's steps along a path, {@link Path#step}, and writes down what each of them finds. */
final class PathRecorder {
    private final FrameInput input;
    private final float[] path = new float[Layout.PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private final List<PathStep> steps = new ArrayList<>();
    private final Deque<Source> waitingSources = new ArrayDeque<>();

    /** Where a ray comes from. */
    private record Source(int parent, RayKind kind) {}

    /**
     * For one path.
     *
     * @param input a single row of the picture
     */
    PathRecorder(FrameInput input) {
        this.input = input;
    }

    List<PathStep> record(int column, int sample) {
        PixelKernel.start(path, column, 0, sample, input.view().frame());
        Medium.begin(path, input.view().frame(), input.variant(false));
        Source source = new Source(PathStep.NO_PARENT, RayKind.VIEW);
        boolean goesOn = true;
        while (goesOn) {
            float[] met = path.clone();
            int body = find(met);
            Optional<SurfaceRecorder> surface = body != Layout.NOTHING && !input.isLight(body)
                    ? Optional.of(new SurfaceRecorder(input, met, scratch, body))
                    : Optional.empty();
            int waiting = waiting();
            clearRadiance();
            goesOn = step();
            steps.add(step(source, body, met, surface.map(found -> found.shading(path))));
            source = waiting() < waiting
                    ? waitingSources.pop()
                    : surface.map(found -> leaving(found, waiting)).orElse(source);
        }
        return List.copyOf(steps);
    }

    /** The source of the ray that leaves a surface; the other one's is kept if it waits. */
    private Source leaving(SurfaceRecorder surface, int waiting) {
        int parent = steps.size() - 1;
        if (waiting() > waiting) {
            int ray = Layout.SCRATCH_RAYS + Layout.RAY_STRIDE * waiting;
            waitingSources.push(new Source(parent, surface.kindOf(scratch, ray)));
        }
        return new Source(parent, surface.kindOf(path, 0));
    }

    private int waiting() {
        return (int) path[Layout.WAITING];
    }

    /** The kernel's own step. */
    private boolean step() {
        Bodies bodies = input.bodies();
        return Path.step(
                        path,
                        scratch,
                        input.view().frame(),
                        bodies.floats(),
                        bodies.looks(),
                        bodies.meshes(),
                        input.images(),
                        input.variant(false))
                != 0;
    }

    private int find(float[] ray) {
        Bodies bodies = input.bodies();
        return Hit.find(
                ray,
                scratch,
                input.view().frame(),
                bodies.floats(),
                bodies.looks(),
                bodies.meshes(),
                input.variant(false));
    }

    /** So that what a step adds is there by itself, with all its digits. */
    private void clearRadiance() {
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = 0;
        }
    }

    private PathStep step(Source source, int body, float[] ray, Optional<ShadedSurface> shading) {
        Vector3 origin = input.bodies().origin();
        Rgb adds = Floats.rgb(path, Layout.RADIANCE);
        return new PathStep(
                source.parent(),
                source.kind(),
                (int) ray[Layout.BOUNCE],
                Floats.place(ray, Layout.ORIGIN, origin),
                Floats.vector(ray, Layout.DIRECTION),
                ray[Layout.INSIDE] > 0,
                Floats.rgb(ray, Layout.THROUGHPUT),
                body,
                body == Layout.NOTHING ? 0 : ray[Layout.DISTANCE],
                shading,
                Optional.empty(),
                Optional.empty(),
                adds);
    }

    /** Three floats of an array as what they mean. */
    static final class Floats {
        private Floats() {}

        static Rgb rgb(float[] array, int at) {
            return new Rgb(array[at], array[at + 1], array[at + 2]);
        }

        static Vector3 vector(float[] array, int at) {
            return new Vector3(array[at], array[at + 1], array[at + 2]);
        }

        /** A place that is seen from the origin, in the scene's own coordinates. */
        static Vector3 place(float[] array, int at, Vector3 origin) {
            return vector(array, at).plus(origin);
        }
    }
}
