package dev.twister.explain;

import dev.twister.kernel.Branch;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Path;
import dev.twister.kernel.PixelKernel;
import dev.twister.scene.Rgb;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Goes through the steps of the kernel's {@link Path#follow}, and writes down what each of them finds. */
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
        Source source = new Source(PathStep.NO_PARENT, RayKind.VIEW);
        int bounce = 0;
        int waiting = 0;
        boolean goesOn = true;
        while (goesOn) {
            int body = find();
            clearRadiance();
            if (body >= Layout.PLANE) {
                SurfaceRecorder surface = new SurfaceRecorder(input, path, scratch, body, bounce, waiting);
                steps.add(step(source, bounce, body, surface.ray(), Optional.of(surface.shading())));
                int parent = steps.size() - 1;
                if (surface.waiting() > waiting) {
                    int ray = Layout.SCRATCH_RAYS + Layout.RAY_STRIDE * waiting;
                    waitingSources.push(new Source(parent, surface.kindOf(scratch, ray)));
                }
                waiting = surface.waiting();
                source = new Source(parent, surface.kindOf(path, 0));
                goesOn = Path.carriesLight(path) != 0;
            } else {
                float[] ray = path.clone();
                Path.end(path, body, input.view().frame(), input.bodies().looks(), input.images());
                steps.add(step(source, bounce, body, ray, Optional.empty()));
                goesOn = false;
            }
            bounce++;
            if (!goesOn && waiting > 0) {
                Branch.resume(path, scratch, waiting);
                bounce = Branch.bounce(scratch, waiting);
                source = waitingSources.pop();
                waiting--;
                goesOn = true;
            }
        }
        return List.copyOf(steps);
    }

    private int find() {
        return Hit.find(
                path,
                scratch,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.variant(false));
    }

    /** So that what a step adds is there by itself, with all its digits. */
    private void clearRadiance() {
        for (int channel = 0; channel < 3; channel++) {
            path[Layout.RADIANCE + channel] = 0;
        }
    }

    private PathStep step(Source source, int bounce, int body, float[] ray, Optional<ShadedSurface> shading) {
        Vector3 origin = input.bodies().origin();
        Rgb adds = Floats.rgb(path, Layout.RADIANCE);
        return new PathStep(
                source.parent(),
                source.kind(),
                bounce,
                Floats.place(ray, Layout.ORIGIN, origin),
                Floats.vector(ray, Layout.DIRECTION),
                ray[Layout.INSIDE] > 0,
                Floats.rgb(ray, Layout.THROUGHPUT),
                body,
                body == Layout.NOTHING ? 0 : ray[Layout.DISTANCE],
                shading,
                adds);
    }
}
