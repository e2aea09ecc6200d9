package dev.twister.explain;

import dev.twister.kernel.Illumination;
import dev.twister.kernel.Layout;
import dev.twister.kernel.Path;
import dev.twister.kernel.Refraction;
import dev.twister.kernel.Shadow;
import dev.twister.scene.Vector3;
import dev.twister.world.FrameInput;
import java.util.List;

/** One surface of a path: lets the kernel shade it and turn the ray, and keeps what was there before. */
final class SurfaceRecorder {
    private final FrameInput input;
    private final float[] before;
    private final float[] facet;
    private final int body;
    private final int bounce;
    private final float visible;
    private final int waiting;

    /** Takes the path, whose ray has met the body, past its surface. */
    SurfaceRecorder(FrameInput input, float[] path, float[] scratch, int body, int bounce, int waitingBefore) {
        this.input = input;
        this.body = body;
        this.bounce = bounce;
        Path.meet(
                path,
                body,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.images(),
                input.variant(false));
        visible = Path.visible(
                path,
                body,
                bounce,
                scratch,
                input.view().frame(),
                input.bodies().floats(),
                input.bodies().looks(),
                input.bodies().meshes(),
                input.variant(false));
        before = path.clone();
        waiting = Path.scatter(
                path,
                body,
                bounce,
                visible,
                scratch,
                waitingBefore,
                input.view().frame(),
                input.bodies().looks(),
                input.variant(false));
        facet = path.clone();
    }

    /** The path as it met the surface. */
    float[] ray() {
        return before;
    }

    /** How many rays wait now. */
    int waiting() {
        return waiting;
    }

    /** Of a ray that begins at the surface: a refracted one goes on to the side that the ray came not from. */
    RayKind kindOf(float[] rays, int at) {
        float cameFrom = dot(before, Layout.DIRECTION, before, Layout.NORMAL);
        float goesTo = dot(rays, at + Layout.DIRECTION, before, Layout.NORMAL);
        return cameFrom * goesTo > 0 ? RayKind.REFRACTED : RayKind.REFLECTED;
    }

    ShadedSurface shading() {
        float[] properties = input.view().frame();
        float transmission = Path.transmission(before, bounce, input.view().frame(), input.variant(false));
        Vector3 origin = input.bodies().origin();
        return new ShadedSurface(
                Floats.place(before, Layout.POINT, origin),
                Floats.vector(before, Layout.NORMAL),
                Floats.rgb(before, Layout.ALBEDO),
                before[Layout.REFLECTIVITY],
                before[Layout.ROUGHNESS],
                before[Layout.IOR],
                Floats.vector(before, Layout.TO_LIGHT),
                before[Layout.NORMAL_DOT_LIGHT],
                visible,
                Illumination.lit(properties[Layout.AMBIENT], before[Layout.NORMAL_DOT_LIGHT], visible),
                Illumination.highlight(before, visible),
                Path.mirror(before, bounce, input.view().frame()),
                transmission,
                transmission > 0 ? reflectance() : 0,
                shadowRays());
    }

    private float reflectance() {
        float cosine = Math.clamp(-dot(before, Layout.DIRECTION, facet, Layout.FACET), 0f, 1f);
        float ior = before[Layout.IOR];
        return Refraction.reflectance(cosine, before[Layout.FROM_INSIDE] > 0 ? ior : 1 / ior);
    }

    private List<LightSample> shadowRays() {
        int traced = Path.isShaded(before, bounce, input.view().frame(), input.variant(false))
                & Shadow.matters(before, input.view().frame());
        return traced == 0 ? List.of() : LightSamples.of(input, before, body);
    }

    private static float dot(float[] a, int atA, float[] b, int atB) {
        return a[atA] * b[atB] + a[atA + 1] * b[atB + 1] + a[atA + 2] * b[atB + 2];
    }
}
