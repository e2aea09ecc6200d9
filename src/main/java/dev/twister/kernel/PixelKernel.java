package dev.twister.kernel;

/**
 * One pixel, from the view ray to what is stored: the kernel that engines call. What draws by equations of its own, as
 * {@code vector} does, is held to its pictures.
 */
public final class PixelKernel {
    /** Values of the argument {@code shortcuts}: the equations as they stand, the exact shortcuts, and those for few spheres. */
    public static final int PLAIN = 0;

    public static final int SHORTCUTS = 1;

    /** The shortcuts, but closest hits by the loop over all bodies: for few spheres, where the walk costs more. */
    public static final int FEW_SPHERES = 2;

    /** Values of the argument {@code output}: 8-bit ARGB into {@code pixels}, or linear floats into {@code radiance}. */
    public static final int ARGB = 0;

    public static final int LINEAR = 1;

    /** The alpha of every pixel, beside 8 bits each of red, green and blue. */
    public static final int OPAQUE = 0xFF000000;

    private PixelKernel() {}

    /**
     * Draws the pixel in that column of that row of the band. The arrays are {@link Layout}'s; a reflection is followed
     * forwards: with throughput T, each hit adds {@code T * (lightColor * spec + (1 - k) * C * lit)} and leaves
     * {@code T * k * lit}, which is the design's recursion unrolled.
     *
     * @param column in [0, width)
     * @param row in [0, rows) of the band
     * @param pixels {@code int[width * rows]} where the output is ARGB, else any
     * @param radiance {@code float[3 * width * rows]} where the output is LINEAR, else any
     * @param scratch {@link Layout#SCRATCH_LENGTH} floats of this thread's own
     */
    public static void draw(
            int column,
            int row,
            int[] pixels,
            float[] radiance,
            int[] dimensions,
            float[] camera,
            float[] rayTracingProperties,
            float[] bodyPositions,
            float[] bodySizes,
            float[] bodyColors,
            float[] bodyReflectivities,
            float[] skybox,
            int[] skyboxDimensions,
            float[] shadowDisc,
            float[] pixelOffsets,
            float[] hierarchy,
            float[] scratch,
            int shortcuts,
            int output) {
        int width = dimensions[Layout.WIDTH];
        int height = dimensions[Layout.HEIGHT];
        int bodies = dimensions[Layout.BODIES];
        int root = Layout.root(bodies);
        int skyWidth = skyboxDimensions[Layout.SKYBOX_WIDTH];
        int skyHeight = skyboxDimensions[Layout.SKYBOX_HEIGHT];
        int shadowSamples = (int) rayTracingProperties[Layout.SHADOW_SAMPLES];
        int bounceLimit = (int) rayTracingProperties[Layout.BOUNCES];
        int pixelSamples = (int) rayTracingProperties[Layout.PIXEL_SAMPLES];
        float ambient = rayTracingProperties[Layout.AMBIENT];
        float lightX = bodyPositions[3 * Layout.LIGHT];
        float lightY = bodyPositions[3 * Layout.LIGHT + 1];
        float lightZ = bodyPositions[3 * Layout.LIGHT + 2];
        float lightRadius = bodySizes[Layout.LIGHT];
        float lightRed = bodyColors[3 * Layout.LIGHT];
        float lightGreen = bodyColors[3 * Layout.LIGHT + 1];
        float lightBlue = bodyColors[3 * Layout.LIGHT + 2];
        float eyeDistance = camera[Layout.CAMERA_EYE_DISTANCE];

        float red = 0f;
        float green = 0f;
        float blue = 0f;
        for (int sample = 0; sample < pixelSamples; sample++) {
            float x = column + pixelOffsets[2 * sample];
            float y = dimensions[Layout.FIRST_ROW] + row + pixelOffsets[2 * sample + 1];
            float u = ViewRay.u(x, width, height);
            float v = ViewRay.v(y, width, height);
            float directionX = u * camera[Layout.CAMERA_RIGHT]
                    + v * camera[Layout.CAMERA_UP]
                    + eyeDistance * camera[Layout.CAMERA_FORWARD];
            float directionY = u * camera[Layout.CAMERA_RIGHT + 1]
                    + v * camera[Layout.CAMERA_UP + 1]
                    + eyeDistance * camera[Layout.CAMERA_FORWARD + 1];
            float directionZ = u * camera[Layout.CAMERA_RIGHT + 2]
                    + v * camera[Layout.CAMERA_UP + 2]
                    + eyeDistance * camera[Layout.CAMERA_FORWARD + 2];
            float viewInverse =
                    KernelMath.inverseRoot(directionX * directionX + directionY * directionY + directionZ * directionZ);
            directionX = directionX * viewInverse;
            directionY = directionY * viewInverse;
            directionZ = directionZ * viewInverse;
            float originX = camera[Layout.CAMERA_POSITION];
            float originY = camera[Layout.CAMERA_POSITION + 1];
            float originZ = camera[Layout.CAMERA_POSITION + 2];
            float throughput = 1f;
            int leaving = Layout.NOTHING;
            int done = 0;
            for (int bounce = 0; bounce <= bounceLimit && done == 0; bounce++) {
                int body;
                if (shortcuts != SHORTCUTS) {
                    body = ClosestHit.body(
                            originX,
                            originY,
                            originZ,
                            directionX,
                            directionY,
                            directionZ,
                            leaving,
                            bodyPositions,
                            bodySizes,
                            bodies);
                } else {
                    body = NearestHit.body(
                            originX,
                            originY,
                            originZ,
                            directionX,
                            directionY,
                            directionZ,
                            leaving,
                            bodyPositions,
                            bodySizes,
                            hierarchy,
                            root,
                            scratch);
                }
                if (body == Layout.NOTHING) {
                    float skyColumn = SkyLookup.column(directionX, directionZ, skyWidth);
                    float skyRow = SkyLookup.row(directionX, directionY, directionZ, skyHeight);
                    red = red + throughput * SkyLookup.radiance(skybox, skyWidth, skyHeight, skyColumn, skyRow, 0);
                    green = green + throughput * SkyLookup.radiance(skybox, skyWidth, skyHeight, skyColumn, skyRow, 1);
                    blue = blue + throughput * SkyLookup.radiance(skybox, skyWidth, skyHeight, skyColumn, skyRow, 2);
                    done = 1;
                }
                if (body == Layout.LIGHT) {
                    red = red + throughput * lightRed;
                    green = green + throughput * lightGreen;
                    blue = blue + throughput * lightBlue;
                    done = 1;
                }
                if (body >= Layout.PLANE) {
                    float distance = ClosestHit.distance(
                            body,
                            originX,
                            originY,
                            originZ,
                            directionX,
                            directionY,
                            directionZ,
                            bodyPositions,
                            bodySizes);
                    float centerX = bodyPositions[3 * body];
                    float centerY = bodyPositions[3 * body + 1];
                    float centerZ = bodyPositions[3 * body + 2];
                    float pointX = originX + distance * directionX;
                    float pointY = originY + distance * directionY;
                    float pointZ = originZ + distance * directionZ;
                    float normalX = 0f;
                    float normalY = 1f;
                    float normalZ = 0f;
                    float albedoRed = bodyColors[3 * body];
                    float albedoGreen = bodyColors[3 * body + 1];
                    float albedoBlue = bodyColors[3 * body + 2];
                    if (body == Layout.PLANE) {
                        pointY = centerY;
                        if (Shading.isEvenSquare(pointX, pointZ) == 0) {
                            albedoRed = rayTracingProperties[Layout.PLANE_ODD_COLOR];
                            albedoGreen = rayTracingProperties[Layout.PLANE_ODD_COLOR + 1];
                            albedoBlue = rayTracingProperties[Layout.PLANE_ODD_COLOR + 2];
                        }
                    } else {
                        normalX = pointX - centerX;
                        normalY = pointY - centerY;
                        normalZ = pointZ - centerZ;
                        float normalInverse =
                                KernelMath.inverseRoot(normalX * normalX + normalY * normalY + normalZ * normalZ);
                        normalX = normalX * normalInverse;
                        normalY = normalY * normalInverse;
                        normalZ = normalZ * normalInverse;
                        pointX = centerX + normalX * bodySizes[body];
                        pointY = centerY + normalY * bodySizes[body];
                        pointZ = centerZ + normalZ * bodySizes[body];
                    }
                    float toLightX = lightX - pointX;
                    float toLightY = lightY - pointY;
                    float toLightZ = lightZ - pointZ;
                    float lightDistanceSquared = toLightX * toLightX + toLightY * toLightY + toLightZ * toLightZ;
                    float lightInverse = KernelMath.inverseRoot(lightDistanceSquared);
                    toLightX = toLightX * lightInverse;
                    toLightY = toLightY * lightInverse;
                    toLightZ = toLightZ * lightInverse;
                    float normalDotLight = normalX * toLightX + normalY * toLightY + normalZ * toLightZ;
                    float reflectivity = bodyReflectivities[body];

                    float visible = 1f;
                    if (shortcuts == PLAIN) {
                        visible = PlainShadow.visible(
                                pointX,
                                pointY,
                                pointZ,
                                body,
                                toLightX,
                                toLightY,
                                toLightZ,
                                lightRadius,
                                shadowSamples,
                                bodyPositions,
                                bodySizes,
                                bodies);
                    } else {
                        int shadowMatters = (normalDotLight > ambient ? 1 : 0)
                                | ((normalDotLight > 0f ? 1 : 0) & (reflectivity > 0f ? 1 : 0));
                        if (shadowMatters != 0) {
                            visible = SoftShadow.visible(
                                    pointX,
                                    pointY,
                                    pointZ,
                                    body,
                                    toLightX,
                                    toLightY,
                                    toLightZ,
                                    lightDistanceSquared * lightInverse,
                                    2f * lightRadius,
                                    shadowSamples,
                                    shadowDisc,
                                    hierarchy,
                                    root,
                                    scratch);
                        }
                    }

                    float lit = Shading.lit(ambient, normalDotLight, visible);
                    float halfX = toLightX - directionX;
                    float halfY = toLightY - directionY;
                    float halfZ = toLightZ - directionZ;
                    float specular = Shading.specular(
                            reflectivity,
                            normalDotLight,
                            normalX * halfX + normalY * halfY + normalZ * halfZ,
                            halfX * halfX + halfY * halfY + halfZ * halfZ,
                            visible);
                    float mirror = bounce < bounceLimit ? reflectivity / Layout.MAX_REFLECTIVITY : 0f;
                    float matte = (1f - mirror) * lit;
                    red = red + throughput * (lightRed * specular + matte * albedoRed);
                    green = green + throughput * (lightGreen * specular + matte * albedoGreen);
                    blue = blue + throughput * (lightBlue * specular + matte * albedoBlue);
                    float passed = mirror * lit;
                    throughput = throughput * passed;
                    done = passed > 0f ? 0 : 1;

                    float directionDotNormal = directionX * normalX + directionY * normalY + directionZ * normalZ;
                    directionX = directionX - 2f * directionDotNormal * normalX;
                    directionY = directionY - 2f * directionDotNormal * normalY;
                    directionZ = directionZ - 2f * directionDotNormal * normalZ;
                    float reflectedInverse = KernelMath.inverseRoot(
                            directionX * directionX + directionY * directionY + directionZ * directionZ);
                    directionX = directionX * reflectedInverse;
                    directionY = directionY * reflectedInverse;
                    directionZ = directionZ * reflectedInverse;
                    originX = pointX;
                    originY = pointY;
                    originZ = pointZ;
                    leaving = body;
                }
            }
        }
        float average = 1f / pixelSamples;
        red = red * average;
        green = green * average;
        blue = blue * average;
        int pixel = row * width + column;
        if (output == LINEAR) {
            radiance[3 * pixel] = red;
            radiance[3 * pixel + 1] = green;
            radiance[3 * pixel + 2] = blue;
        } else {
            float exposureScale = rayTracingProperties[Layout.EXPOSURE_SCALE];
            int toneMap = (int) rayTracingProperties[Layout.TONE_MAP];
            float srgb = rayTracingProperties[Layout.SRGB];
            pixels[pixel] = OPAQUE
                    | (ToneMapping.quantized(red, exposureScale, toneMap, srgb) << 16)
                    | (ToneMapping.quantized(green, exposureScale, toneMap, srgb) << 8)
                    | ToneMapping.quantized(blue, exposureScale, toneMap, srgb);
        }
    }
}
