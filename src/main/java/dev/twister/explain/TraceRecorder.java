package dev.twister.explain;

import dev.twister.explain.PathRecorder.Floats;
import dev.twister.explain.PathStep.FoundLight;
import dev.twister.explain.PathStep.RayKind;
import dev.twister.explain.PathStep.Scattering;
import dev.twister.explain.PathStep.Scattering.EmitterChoice;
import dev.twister.explain.PathStep.Scattering.LobeChoice;
import dev.twister.explain.PathStep.Scattering.LobeProbabilities;
import dev.twister.kernel.Emitter;
import dev.twister.kernel.Hit;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Lobes;
import dev.twister.kernel.PathTracer;
import dev.twister.kernel.PixelKernel;
import dev.twister.kernel.SkyLookup;
import dev.twister.kernel.SunEmitter;
import dev.twister.kernel.Variant;
import dev.twister.scene.Rgb;
import dev.twister.world.FrameInput;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Takes the kernel's steps along a path of the integrator {@code path}, {@link PathTracer#step}, and writes down what
 * each of them finds. What a step does not leave in the path is asked of the kernel on a copy.
 */
final class TraceRecorder {
    private static final int CHANNELS = 3;
    private static final FoundLight DARK = new FoundLight(new Rgb(0, 0, 0), 0, 0, 0);

    private final FrameInput input;
    private final float[] frame;
    private final float[] bodies;
    private final float[] looks;
    private final float[] meshes;
    private final int variant;
    private final float[] path = new float[Layout.FINISHED_PATH_LENGTH];
    private final float[] scratch = new float[Layout.SCRATCH_LENGTH];
    private final List<PathStep> steps = new ArrayList<>();

    /** What the emitter chosen at the last surface adds unless it is blocked. */
    private FoundLight direct = DARK;

    private Rgb directThroughput = DARK.radiance();
    private int directBody = Layout.NOTHING;

    /** Where a ray comes from. */
    private record Source(int parent, RayKind kind) {}

    /**
     * For one path.
     *
     * @param input a single row of the picture
     */
    TraceRecorder(FrameInput input) {
        this.input = input;
        frame = input.view().frame();
        bodies = input.bodies().floats();
        looks = input.bodies().looks();
        meshes = input.bodies().meshes();
        variant = input.variant(false);
    }

    List<PathStep> record(int column, int sample) {
        PixelKernel.start(path, column, 0, sample, frame);
        PathTracer.begin(path, frame, variant);
        Source source = new Source(PathStep.NO_PARENT, RayKind.VIEW);
        int surface = PathStep.NO_PARENT;
        int bounce = 0;
        int ray = PathTracer.TO_SURFACE;
        while (ray != PathTracer.NO_RAY) {
            float[] before = path.clone();
            boolean toEmitter = ray == PathTracer.TO_EMITTER;
            clearRadiance();
            ray = PathTracer.step(path, bounce, ray, scratch, frame, bodies, looks, meshes, input.images(), variant);
            if (toEmitter) {
                steps.add(toEmitter(before, bounce, new Source(surface, RayKind.EMITTER)));
            } else {
                addSuns(before, bounce, source);
                PathStep met = toSurface(before, bounce, source);
                surface = steps.size();
                source = met.scattering()
                        .flatMap(Scattering::next)
                        .map(next -> new Source(steps.size(), next.kind()))
                        .orElse(source);
                steps.add(met);
                bounce++;
            }
        }
        return List.copyOf(steps);
    }

    /** So that what a step adds is there by itself, with all its digits. */
    private void clearRadiance() {
        for (int channel = 0; channel < CHANNELS; channel++) {
            path[Layout.RADIANCE + channel] = 0;
        }
    }

    private PathStep toSurface(float[] ray, int bounce, Source source) {
        int body = Hit.find(ray, scratch, frame, bodies, looks, meshes, variant);
        if (body > Layout.NOTHING) {
            PathTracer.meet(ray, body, frame, bodies, looks, meshes, input.images(), variant);
        }
        Optional<FoundLight> light = metLight(ray, body);
        Rgb throughput = Floats.rgb(ray, Layout.THROUGHPUT);
        boolean scatters = body > Layout.LIGHT && !input.isLight(body) && bounce <= (int) frame[Layout.BOUNCES];
        Optional<Scattering> scattering =
                scatters ? Optional.of(scattering(ray.clone(), body, bounce)) : Optional.empty();
        Rgb adds = body == Layout.NOTHING ? addedBySky(ray, bounce) : Floats.rgb(path, Layout.RADIANCE);
        return step(source, bounce, ray, throughput, body, light, scattering, adds);
    }

    private Rgb addedBySky(float[] ray, int bounce) {
        float[] alone = frame.clone();
        alone[Layout.SUNS] = 0;
        return added(ray, bounce, alone);
    }

    /** Adds a step for each sun that a ray to the sky passes. */
    private void addSuns(float[] ray, int bounce, Source source) {
        int suns = Hit.find(ray, scratch, frame, bodies, looks, meshes, variant) == Layout.NOTHING
                ? (int) frame[Layout.SUNS]
                : 0;
        for (int sun = 0; sun < suns; sun++) {
            int emitter = SunEmitter.first(frame) + Layout.EMITTER_STRIDE * sun;
            int body = (int) looks[emitter + Layout.EMITTER_BODY];
            if (SunEmitter.isMet(ray, body, looks) != 0) {
                int emission = Layout.LOOK_STRIDE * body + Layout.LOOK_EMISSION;
                FoundLight light = light(looks, emission, ray, SunEmitter.density(emitter, looks));
                float[] alone = frame.clone();
                alone[Layout.SUNS] = 1;
                alone[Layout.EMITTERS] = frame[Layout.EMITTERS] - frame[Layout.SUNS] + sun + 1;
                alone[Layout.SKY_STRENGTH] = 0;
                Rgb throughput = Floats.rgb(ray, Layout.THROUGHPUT);
                steps.add(step(
                        source,
                        bounce,
                        ray,
                        throughput,
                        body,
                        Optional.of(light),
                        Optional.empty(),
                        added(ray, bounce, alone)));
            }
        }
    }

    /**
     * What a ray that meets no body adds.
     *
     * @param far the frame's values with some of the suns, or without sky
     */
    private Rgb added(float[] ray, int bounce, float[] far) {
        float[] copy = ray.clone();
        for (int channel = 0; channel < CHANNELS; channel++) {
            copy[Layout.RADIANCE + channel] = 0;
        }
        PathTracer.arrive(copy, Layout.NOTHING, bounce, scratch, far, bodies, looks, meshes, input.images(), variant);
        return Floats.rgb(copy, Layout.RADIANCE);
    }

    /** The light of the emitter or the sky that the ray has met. */
    private Optional<FoundLight> metLight(float[] ray, int body) {
        if (body == Layout.NOTHING) {
            SkyLookup.write(ray, Layout.DIRECTION, Layout.EMITTED, frame, input.images());
            return Optional.of(light(ray, Layout.EMITTED, ray, Emitter.skyDensity(ray, frame, looks, input.images())));
        }
        if (Emitter.shines(ray, body, frame, looks, variant) == 0) {
            return Optional.empty();
        }
        PathTracer.emit(ray, body, looks, variant);
        return Optional.of(light(ray, Layout.EMITTED, ray, Emitter.density(ray, body, frame, bodies, looks, variant)));
    }

    private static FoundLight light(float[] array, int radiance, float[] ray, float emitterDensity) {
        float density = ray[Layout.SURFACE_DENSITY];
        return new FoundLight(
                Floats.rgb(array, radiance),
                density,
                emitterDensity,
                density > 0 ? PathTracer.weight(density, emitterDensity) : 1);
    }

    /** @param ray a copy of the path at the surface, on which the step is repeated */
    private Scattering scattering(float[] ray, int body, int bounce) {
        Lobes.prepare(ray, body, bounce, frame, looks, variant);
        boolean last = bounce >= (int) frame[Layout.BOUNCES];
        Optional<EmitterChoice> emitter = Lobes.scatters(ray, variant) != 0 && frame[Layout.EMITTERS] > 0
                ? Optional.of(emitter(ray, body, bounce, last))
                : Optional.empty();
        return new Scattering(
                Floats.place(ray, Layout.POINT, input.bodies().origin()),
                Floats.vector(ray, Layout.NORMAL),
                Floats.rgb(ray, Layout.ALBEDO),
                ray[Layout.ROUGHNESS],
                lobes(ray),
                emitter,
                Optional.of(next(ray, bounce)).filter(_ -> PathTracer.endsAt(ray, bounce, frame) == 0));
    }

    private LobeProbabilities lobes(float[] ray) {
        boolean finished = (variant & Variant.FINISH) != 0 && ray[Layout.IS_FINISHED] > 0;
        return new LobeProbabilities(
                Lobes.choice(ray, Lobes.MIRROR),
                Lobes.choice(ray, Lobes.MATTE),
                Lobes.choice(ray, Lobes.GLASS),
                finished ? Lobes.choice(ray, Lobes.COAT) : 0,
                finished ? Lobes.choice(ray, Lobes.THROUGH) : 0);
    }

    private EmitterChoice emitter(float[] ray, int body, int bounce, boolean last) {
        int emitter = Emitter.chosen(ray, bounce, frame, looks);
        Emitter.choose(ray, bounce, frame, bodies, looks, meshes, input.images(), variant);
        float chosen = ray[Layout.LIGHT_DENSITY];
        float density = PathTracer.evaluateToLight(ray, body, looks, variant);
        // After the last bounce no ray is scattered that could meet the emitter, too.
        float weight = last ? 1 : PathTracer.weight(chosen, density);
        direct = new FoundLight(Floats.rgb(ray, Layout.EMITTED), density, chosen, weight);
        directThroughput = new Rgb(direct(ray, 0), direct(ray, 1), direct(ray, 2));
        directBody = (int) looks[emitter + Layout.EMITTER_BODY];
        return new EmitterChoice(directBody, ray[Layout.CHOICE]);
    }

    /** {@code T * f * |cos| / p} of a channel. */
    private static float direct(float[] ray, int channel) {
        return ray[Layout.THROUGHPUT + channel] * ray[Layout.SCATTERED + channel] / ray[Layout.LIGHT_DENSITY];
    }

    private LobeChoice next(float[] ray, int bounce) {
        float[] before = ray.clone();
        for (int channel = 0; channel < CHANNELS; channel++) {
            ray[Layout.THROUGHPUT + channel] = 1;
        }
        Lobes.choose(ray, bounce, frame, looks, variant);
        int lobe = Lobes.chosen(ray, bounce, frame, variant);
        Rgb factor = Floats.rgb(ray, Layout.THROUGHPUT);
        for (int channel = 0; channel < CHANNELS; channel++) {
            ray[Layout.THROUGHPUT + channel] *= before[Layout.THROUGHPUT + channel];
        }
        return new LobeChoice(
                switch (lobe) {
                    case Lobes.MIRROR, Lobes.COAT -> RayKind.REFLECTED;
                    case Lobes.MATTE, Lobes.THROUGH -> RayKind.SCATTERED;
                    default -> RayKind.REFRACTED;
                },
                Lobes.choice(ray, lobe),
                ray[Layout.SURFACE_DENSITY],
                factor,
                bounce >= PathTracer.FIRST_ROULETTE ? PathTracer.survival(ray) : 1,
                path[Layout.THROUGHPUT] + path[Layout.THROUGHPUT + 1] + path[Layout.THROUGHPUT + 2] > 0);
    }

    /** @param ray the path at a surface, whose ray leads to the chosen emitter */
    private PathStep toEmitter(float[] ray, int bounce, Source source) {
        float limit = ray[Layout.LIGHT_DISTANCE];
        int blocker = Hit.within(ray, limit, scratch, frame, bodies, looks, meshes, variant);
        if (blocker == Layout.NOTHING) {
            ray[Layout.DISTANCE] = limit;
        }
        return step(
                source,
                bounce,
                ray,
                directThroughput,
                blocker == Layout.NOTHING ? directBody : blocker,
                Optional.of(direct),
                Optional.empty(),
                Floats.rgb(path, Layout.RADIANCE));
    }

    private PathStep step(
            Source source,
            int bounce,
            float[] ray,
            Rgb throughput,
            int body,
            Optional<FoundLight> light,
            Optional<Scattering> scattering,
            Rgb adds) {
        boolean isFar = body == Layout.NOTHING || input.isSun(body);
        return new PathStep(
                source.parent(),
                source.kind(),
                bounce,
                Floats.place(ray, Layout.ORIGIN, input.bodies().origin()),
                Floats.vector(ray, Layout.DIRECTION),
                ray[Layout.INSIDE] > 0,
                throughput,
                body,
                isFar ? 0 : ray[Layout.DISTANCE],
                Optional.empty(),
                light,
                scattering,
                adds);
    }
}
