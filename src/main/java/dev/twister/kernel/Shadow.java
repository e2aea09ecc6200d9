package dev.twister.kernel;

/**
 * The visible part of the light's disc: equal to testing every shadow ray against every body, rounding aside, but much
 * faster.
 *
 * <p>The frame has the surface point at its origin, the axis A toward the light's center at distance D, and the disc's
 * axes U and W. A shadow ray goes through (D, x, y), where (x, y) is the sample's position on the disc. A sphere at (a,
 * u, w) meets its line if the perpendicular distance is at most the radius: {@code |(a, u, w) x (D, x, y)|^2 <=
 * radius^2 * |(D, x, y)|^2}. With x' = x / D, y' = y / D, p = u - a x' and q = w - a y' that is {@code (p y' - q x')^2
 * + p^2 + q^2 <= radius^2 * (1 + x'^2 + y'^2)}, which needs no square root and subtracts large numbers only where they
 * cancel exactly.
 *
 * <p>Spheres that cannot meet the cone from the point to the disc are culled first, and so is the plane
 * ({@link PlaneShadow}). For most points no candidates remain.
 */
public final class Shadow {
    /** Results of {@link #judge}. */
    public static final int HARMLESS = 0;

    public static final int CANDIDATE = 1;
    public static final int HIDES_ALL = 2;

    /** Result of {@link #candidates} if a sphere certainly blocks the whole disc. */
    private static final int ALL_HIDDEN = -1;

    /** Margins that keep culling conservative: rounding never drops an occluder. */
    public static final float RELATIVE_MARGIN = 1.0005f;

    public static final float ABSOLUTE_MARGIN = 1.0e-5f;

    /** Margin for spheres that block the whole disc without tests of the samples. */
    public static final float UMBRA_MARGIN = 0.999f;

    private Shadow() {}

    /**
     * S in [0, 1] at {@link Layout#POINT}: 1 - blocked / samples, where transmitting bodies block only partly. 0 if a
     * mesh's face looks away from the light. 1 if S has no effect, because the light is behind the surface or adds less
     * than the ambient light.
     *
     * @param path {@link Layout#PATH_LENGTH} floats
     * @param own the body that the point lies on
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats
     */
    public static float visible(
            float[] path,
            int own,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float visible = 1f;
        if (Surface.isMesh(own, frame, variant) != 0) {
            visible = MeshSurface.looksAway(path) != 0 ? 0f : 1f;
        }
        int matters = (Variant.stageOrView(variant) == Views.SHADOW ? 1 : 0) | matters(path, frame, variant);
        if ((matters & (visible > 0f ? 1 : 0)) != 0) {
            int light = Illumination.shading(path, variant);
            float discRadius = 2f * bodies[Layout.PLACE_STRIDE * light + Layout.PLACE_SIZE];
            face(path, discRadius, frame);
            int plane = PlaneShadow.mayBlock(path, own, discRadius, bodies, looks, variant);
            int count = candidates(path, own, scratch, frame, bodies, looks, variant);
            visible = count == ALL_HIDDEN ? 0f : 1f;
            int mesh = 0;
            if ((variant & Variant.MESHES) != 0) {
                mesh = MeshShadow.mayBlock(path, scratch, frame, bodies, variant);
            }
            int inDoubt = (count > 0 ? 1 : 0) | ((count == 0 ? 1 : 0) & (plane | mesh));
            if (inDoubt != 0) {
                float blocked =
                        blocked(path, own, plane | (mesh << 1), count, scratch, frame, bodies, looks, meshes, variant);
                visible = 1f - blocked / (int) frame[Layout.SHADOW_SAMPLES];
            }
        }
        return visible;
    }

    /** 1 if S affects the surface's reflected light, else 0. With several lights that is so for all in front. */
    public static int matters(float[] path, float[] frame, int variant) {
        float cosine = path[Layout.NORMAL_DOT_LIGHT];
        float least = Illumination.ambient(path, frame, variant);
        if ((variant & Variant.LIGHTS) != 0) {
            least = 0f;
        }
        return (cosine > least ? 1 : 0) | ((cosine > 0f ? 1 : 0) & (path[Layout.REFLECTIVITY] > 0f ? 1 : 0));
    }

    /**
     * Writes the disc's axes, scale and half angle, seen from the point.
     *
     * @param discRadius twice the light's radius, in meters: the radius of the sunflower
     */
    static void face(float[] path, float discRadius, float[] frame) {
        int samples = (int) frame[Layout.SHADOW_SAMPLES];
        float axisX = path[Layout.TO_LIGHT];
        float axisY = path[Layout.TO_LIGHT + 1];
        float axisZ = path[Layout.TO_LIGHT + 2];
        float acrossSquared = axisY * axisY + axisZ * axisZ;
        float scale = KernelMath.inverseRoot(acrossSquared > 0f ? acrossSquared : axisX * axisX);
        float uY = acrossSquared > 0f ? axisZ * scale : 0f;
        float uZ = acrossSquared > 0f ? -axisY * scale : axisX * scale;
        path[Layout.DISC_U_Y] = uY;
        path[Layout.DISC_U_Z] = uZ;
        path[Layout.DISC_W] = uY * axisZ - uZ * axisY;
        path[Layout.DISC_W + 1] = uZ * axisX;
        path[Layout.DISC_W + 2] = -uY * axisX;
        float distance = path[Layout.LIGHT_DISTANCE];
        float sampleScale = discRadius * (distance > 0f ? 1f / distance : 0f);
        float rimX = frame[Layout.DISC + 2 * samples - 2];
        float rimY = frame[Layout.DISC + 2 * samples - 1];
        float tangent = sampleScale * (float) Math.sqrt(rimX * rimX + rimY * rimY);
        path[Layout.DISC_SCALE] = sampleScale;
        path[Layout.DISC_TANGENT] = tangent;
        path[Layout.DISC_SECANT] = (float) Math.sqrt(1f + tangent * tangent);
    }

    /**
     * The number of samples blocked by the plane, the candidates in the scratch (or, if there are more, any sphere) and
     * the meshes.
     *
     * @param own the body that the point lies on
     * @param occluders 1 if the plane may block any, plus 2 if a mesh may
     * @param count result of {@link #candidates}
     */
    private static float blocked(
            float[] path,
            int own,
            int occluders,
            int count,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            int variant) {
        float distance = path[Layout.LIGHT_DISTANCE];
        int plane = occluders & 1;
        int mesh = occluders >> 1;
        int samples = (int) frame[Layout.SHADOW_SAMPLES];
        float sampleScale = path[Layout.DISC_SCALE];
        int remembered = Math.min(count, Layout.MOST_CANDIDATES);
        int alone = ((count == 1 ? 1 : 0) & (1 - (plane | mesh))) != 0 ? liesBetween(scratch, distance) : 0;
        float blocked = alone != 0
                ? blockedByOne(scratch, sampleScale, samples, frame)
                        * (1f - rememberedTransmission(scratch, 0, variant))
                : 0f;
        Views.count(path, Views.TESTS, alone != 0 ? samples : 0, variant);
        int firstSample = alone != 0 ? samples : 0;
        for (int sample = firstSample; sample < samples; sample++) {
            float x = frame[Layout.DISC + 2 * sample] * sampleScale;
            float y = frame[Layout.DISC + 2 * sample + 1] * sampleScale;
            float pastPlane = 1f;
            if (plane != 0) {
                Views.count(path, Views.TESTS, 1, variant);
                pastPlane = PlaneShadow.blocks(path, x, y, bodies, looks, variant) != 0
                        ? transmission(Layout.PLANE, looks, variant)
                        : 1f;
            }
            float light = pastPlane;
            int lit = light > 0f ? 1 : 0;
            for (int candidate = 0; candidate < remembered && lit != 0; candidate++) {
                Views.count(path, Views.TESTS, 1, variant);
                float transmission = rememberedTransmission(scratch, candidate, variant);
                int hit = blocks(
                        scratch[Layout.CANDIDATE_STRIDE * candidate],
                        scratch[Layout.CANDIDATE_STRIDE * candidate + 1],
                        scratch[Layout.CANDIDATE_STRIDE * candidate + 2],
                        scratch[Layout.CANDIDATE_STRIDE * candidate + 3],
                        x,
                        y,
                        distance,
                        transmission);
                light = hit != 0 ? light * transmission : light;
                lit = light > 0f ? 1 : 0;
            }
            int forgotten = (count > Layout.MOST_CANDIDATES ? 1 : 0) & lit;
            if (forgotten != 0) {
                light = pastPlane * ShadowRay.light(path, own, x, y, scratch, frame, bodies, looks, variant);
            }
            if ((variant & Variant.MESHES) != 0) {
                if ((mesh & (light > 0f ? 1 : 0)) != 0) {
                    light = light * MeshShadow.light(path, own, x, y, scratch, frame, bodies, looks, meshes, variant);
                }
            }
            blocked = blocked + (1f - light);
        }
        return blocked;
    }

    /** Transmission of a stored candidate, in [0, 1]. */
    private static float rememberedTransmission(float[] scratch, int candidate, int variant) {
        float transmission = 0f;
        if ((variant & Variant.MATERIALS) != 0) {
            transmission = scratch[Layout.SCRATCH_TRANSMISSIONS + candidate];
        }
        return transmission;
    }

    /** Transmission of a body, in [0, 1]. */
    public static float transmission(int body, float[] looks, int variant) {
        float transmission = 0f;
        if ((variant & Variant.MATERIALS) != 0) {
            transmission = looks[Layout.LOOK_STRIDE * body + Layout.LOOK_TRANSMISSION];
        }
        return transmission;
    }

    /**
     * Finds the spheres that may lie between the point and the disc, and writes the first
     * {@link Layout#MOST_CANDIDATES} to the scratch.
     *
     * @return their number, or a lower bound if there are more than that, or {@link #ALL_HIDDEN}
     */
    private static int candidates(
            float[] path, int own, float[] scratch, float[] frame, float[] bodies, float[] looks, int variant) {
        int count = 0;
        if ((variant & Variant.WALK) == 0) {
            int root = (int) frame[Layout.SHADOW_ROOT];
            int link = (int) bodies[root + Layout.NODE_LINK];
            int spheres = (int) bodies[root + Layout.NODE_SPHERES];
            count = addLeaf(path, own, 0, link, spheres, scratch, frame, bodies, looks, variant);
        }
        if ((variant & Variant.WALK) != 0) {
            count = onWalk(path, own, scratch, frame, bodies, looks, variant);
        }
        return count;
    }

    /** As above, through the hierarchy. */
    private static int onWalk(
            float[] path, int own, float[] scratch, float[] frame, float[] bodies, float[] looks, int variant) {
        float axisX = path[Layout.TO_LIGHT];
        float axisY = path[Layout.TO_LIGHT + 1];
        float axisZ = path[Layout.TO_LIGHT + 2];
        float tangent = path[Layout.DISC_TANGENT];
        float spreadX = NodeBox.spread(axisY, axisZ, tangent);
        float spreadY = NodeBox.spread(axisZ, axisX, tangent);
        float spreadZ = NodeBox.spread(axisX, axisY, tangent);
        float leastX = NodeBox.inverse(axisX - spreadX);
        float leastY = NodeBox.inverse(axisY - spreadY);
        float leastZ = NodeBox.inverse(axisZ - spreadZ);
        float greatestX = NodeBox.inverse(axisX + spreadX);
        float greatestY = NodeBox.inverse(axisY + spreadY);
        float greatestZ = NodeBox.inverse(axisZ + spreadZ);
        float end = path[Layout.LIGHT_DISTANCE] * RELATIVE_MARGIN;
        int node = (int) frame[Layout.SHADOW_ROOT];
        float growth = NodeBox.coneGrowth(path, bodies, node);
        int count = 0;
        int waiting = 0;
        while (node != Layout.NO_NODE) {
            int link = (int) bodies[node + Layout.NODE_LINK];
            int spheres = (int) bodies[node + Layout.NODE_SPHERES];
            int next = Layout.NO_NODE;
            if (spheres < 0) {
                Views.count(path, Views.TESTS, 2, variant);
                float first = NodeBox.coneEntry(
                        path, bodies, link, leastX, leastY, leastZ, greatestX, greatestY, greatestZ, growth);
                float second = NodeBox.coneEntry(
                        path,
                        bodies,
                        link + Layout.NODE_STRIDE,
                        leastX,
                        leastY,
                        leastZ,
                        greatestX,
                        greatestY,
                        greatestZ,
                        growth);
                int swapped = second < first ? Layout.NODE_STRIDE : 0;
                float near = second < first ? second : first;
                float far = second < first ? first : second;
                if (far < end) {
                    scratch[Layout.SCRATCH_SHADOW_STACK + waiting] = link + Layout.NODE_STRIDE - swapped;
                    waiting = waiting + 1;
                }
                next = near < end ? link + swapped : Layout.NO_NODE;
            }
            if (spheres > 0) {
                count = addLeaf(path, own, count, link, spheres, scratch, frame, bodies, looks, variant);
            }
            if (((next == Layout.NO_NODE ? 1 : 0) & (waiting > 0 ? 1 : 0)) != 0) {
                waiting = waiting - 1;
                next = (int) scratch[Layout.SCRATCH_SHADOW_STACK + waiting];
            }
            int known = (count == ALL_HIDDEN ? 1 : 0) | (count > Layout.MOST_CANDIDATES ? 1 : 0);
            node = known == 0 ? next : Layout.NO_NODE;
        }
        return count;
    }

    /**
     * Adds the candidates of a leaf.
     *
     * @return their number so far, or {@link #ALL_HIDDEN}
     */
    private static int addLeaf(
            float[] path,
            int own,
            int found,
            int link,
            int spheres,
            float[] scratch,
            float[] frame,
            float[] bodies,
            float[] looks,
            int variant) {
        int count = found;
        for (int sphere = 0; sphere < spheres && count != ALL_HIDDEN; sphere++) {
            int at = link + Layout.SPHERE_STRIDE * sphere;
            int body = (int) bodies[at + Layout.SPHERE_BODY];
            if (isOwn(own, at, body, frame, bodies, variant) == 0) {
                Views.count(path, Views.TESTS, 1, variant);
                float x = bodies[at] - path[Layout.POINT];
                float y = bodies[at + 1] - path[Layout.POINT + 1];
                float z = bodies[at + 2] - path[Layout.POINT + 2];
                float radius = bodies[at + Layout.SPHERE_RADIUS];
                float a = x * path[Layout.TO_LIGHT] + y * path[Layout.TO_LIGHT + 1] + z * path[Layout.TO_LIGHT + 2];
                float u = path[Layout.DISC_U_Y] * y + path[Layout.DISC_U_Z] * z;
                float w = path[Layout.DISC_W] * x + path[Layout.DISC_W + 1] * y + path[Layout.DISC_W + 2] * z;
                float distance = path[Layout.LIGHT_DISTANCE];
                float tangent = path[Layout.DISC_TANGENT];
                float secant = path[Layout.DISC_SECANT];
                int judgment = judge(a, u, w, radius, distance, tangent, secant);
                if (transmission(body, looks, variant) > 0f) {
                    judgment =
                            mayReach(a, u * u + w * w, radius, distance, tangent, secant) != 0 ? CANDIDATE : HARMLESS;
                }
                if (judgment == CANDIDATE) {
                    remember(count, a, u, w, radius, scratch);
                    rememberTransmission(count, transmission(body, looks, variant), scratch, variant);
                    count = count + 1;
                }
                count = judgment == HIDES_ALL ? ALL_HIDDEN : count;
            }
        }
        return count;
    }

    /** 1 if a sphere is the body that the point lies on, or in its place, else 0. */
    static int isOwn(int own, int at, int body, float[] frame, float[] bodies, int variant) {
        int same = body == own ? 1 : 0;
        if ((variant & Variant.TWINS) != 0) {
            same = same | Twin.is(own, at, body, frame, bodies);
        }
        return same;
    }

    private static void remember(int candidate, float a, float u, float w, float radius, float[] scratch) {
        if (candidate < Layout.MOST_CANDIDATES) {
            scratch[Layout.CANDIDATE_STRIDE * candidate] = a;
            scratch[Layout.CANDIDATE_STRIDE * candidate + 1] = u;
            scratch[Layout.CANDIDATE_STRIDE * candidate + 2] = w;
            scratch[Layout.CANDIDATE_STRIDE * candidate + 3] = radius * radius;
        }
    }

    private static void rememberTransmission(int candidate, float transmission, float[] scratch, int variant) {
        if ((variant & Variant.MATERIALS) != 0) {
            if (candidate < Layout.MOST_CANDIDATES) {
                scratch[Layout.SCRATCH_TRANSMISSIONS + candidate] = transmission;
            }
        }
    }

    /**
     * Whether a sphere with its center at (a, u, w) may lie between the point and the disc, and whether it certainly
     * blocks the whole disc.
     */
    public static int judge(float a, float u, float w, float radius, float distance, float tangent, float secant) {
        float across = u * u + w * w;
        int judgment = HARMLESS;
        if (mayMeet(a, across, radius, distance, tangent, secant) != 0) {
            judgment = hidesDisc(a, across, radius, distance, tangent, secant) != 0 ? HIDES_ALL : CANDIDATE;
        }
        return judgment;
    }

    /**
     * 1 if a sphere may meet the cone, given its center's distance a along the axis and squared distance from the axis.
     */
    static int mayMeet(float a, float across, float radius, float distance, float tangent, float secant) {
        return mayReach(a, across, radius, distance, tangent, secant) & (a * a + across > radius * radius ? 1 : 0);
    }

    /** As above, for a sphere that is also visible from inside. */
    private static int mayReach(float a, float across, float radius, float distance, float tangent, float secant) {
        float reach =
                (a * tangent + radius * secant) * RELATIVE_MARGIN + ABSOLUTE_MARGIN * (Math.abs(a) + distance + radius);
        return (a + radius > 0f ? 1 : 0)
                & (a - radius < distance * RELATIVE_MARGIN ? 1 : 0)
                & (reach > 0f ? 1 : 0)
                & (across <= reach * reach ? 1 : 0);
    }

    /**
     * 1 if the first candidate lies entirely between the point and the disc, so that only its distance from a ray
     * matters.
     */
    private static int liesBetween(float[] scratch, float distance) {
        float radius = (float) Math.sqrt(scratch[3]);
        return (scratch[0] - radius > 0f ? 1 : 0) & (scratch[0] + radius < distance * UMBRA_MARGIN ? 1 : 0);
    }

    /**
     * The number of samples blocked by the first candidate, which lies entirely between. Most points in a penumbra have
     * only one.
     */
    private static int blockedByOne(float[] scratch, float sampleScale, int samples, float[] frame) {
        float a = scratch[0];
        float u = scratch[1];
        float w = scratch[2];
        float radiusSquared = scratch[3];
        int blocked = 0;
        for (int sample = 0; sample < samples; sample++) {
            float x = frame[Layout.DISC + 2 * sample] * sampleScale;
            float y = frame[Layout.DISC + 2 * sample + 1] * sampleScale;
            float p = u - a * x;
            float q = w - a * y;
            float moment = p * y - q * x;
            int met = moment * moment + p * p + q * q <= radiusSquared * (1f + x * x + y * y) ? 1 : 0;
            blocked = blocked + met;
        }
        return blocked;
    }

    /**
     * 1 if a sphere blocks the shadow ray through (1, x, y) * distance: it meets the line, and its near side lies
     * between the point and the sample. From a point inside, only a transmitting sphere blocks, by its far side.
     */
    public static int blocks(
            float a, float u, float w, float radiusSquared, float x, float y, float distance, float transmission) {
        float p = u - a * x;
        float q = w - a * y;
        float moment = p * y - q * x;
        float lengthSquared = 1f + x * x + y * y;
        int blocks = 0;
        if (moment * moment + p * p + q * q <= radiusSquared * lengthSquared) {
            float along = a + x * u + y * w;
            float beyondA = distance - a;
            float beyondU = distance * x - u;
            float beyondW = distance * y - w;
            float beyondSquared = beyondA * beyondA + beyondU * beyondU + beyondW * beyondW;
            int before = (along < distance * lengthSquared ? 1 : 0) | (beyondSquared < radiusSquared ? 1 : 0);
            int outside = a * a + u * u + w * w > radiusSquared ? 1 : 0;
            int leaves = (transmission > 0f ? 1 : 0) & (beyondSquared >= radiusSquared ? 1 : 0);
            blocks = outside != 0 ? (along > 0f ? 1 : 0) & before : leaves;
        }
        return blocks;
    }

    /**
     * 1 if the sphere certainly blocks the whole disc: it lies entirely between point and disc, and its cone contains
     * the disc's cone, {@code sin(theta + alpha) <= radius / distance of the center}. Here theta is the angle between A
     * and the center, and alpha the disc's half angle; their sum must be below a right angle.
     */
    private static int hidesDisc(float a, float across, float radius, float distance, float tangent, float secant) {
        float perpendicular = (float) Math.sqrt(across);
        return (a - radius > 0f ? 1 : 0)
                & (a + radius < distance * UMBRA_MARGIN ? 1 : 0)
                & (a > perpendicular * tangent ? 1 : 0)
                & (perpendicular + a * tangent <= radius * secant * UMBRA_MARGIN ? 1 : 0);
    }
}
