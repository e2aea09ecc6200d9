package dev.twister.kernel;

/** Blinn-Phong at a strip's points, and the rays reflected there, see {@link Shading}. */
final class StripShading {
    private StripShading() {}

    /** Finds {@code max(0, N.H)^p} in each lane. */
    static void power(int pixels, float[] lanes) {
        int fractions = 0;
        for (int lane = 0; lane < pixels; lane++) {
            float halfX = lanes[Strip.TO_LIGHT_X + lane] - lanes[Strip.DIRECTION_X + lane];
            float halfY = lanes[Strip.TO_LIGHT_Y + lane] - lanes[Strip.DIRECTION_Y + lane];
            float halfZ = lanes[Strip.TO_LIGHT_Z + lane] - lanes[Strip.DIRECTION_Z + lane];
            float cosine = Shading.halfCosine(
                    lanes[Strip.NORMAL_X + lane] * halfX
                            + lanes[Strip.NORMAL_Y + lane] * halfY
                            + lanes[Strip.NORMAL_Z + lane] * halfZ,
                    halfX * halfX + halfY * halfY + halfZ * halfZ);
            float exponent = lanes[Strip.REFLECTIVITY + lane];
            int whole = (int) exponent;
            lanes[Strip.COSINE + lane] = cosine;
            lanes[Strip.POWER + lane] = KernelMath.wholePower(cosine, whole);
            fractions = fractions + (exponent > whole ? 1 : 0);
        }
        if (fractions > 0) {
            for (int lane = 0; lane < pixels; lane++) {
                float exponent = lanes[Strip.REFLECTIVITY + lane];
                lanes[Strip.POWER + lane] = lanes[Strip.POWER + lane]
                        * KernelMath.fractionalPower(lanes[Strip.COSINE + lane], exponent - (int) exponent);
            }
        }
    }

    /**
     * Adds what each point sends to the eye and turns its ray to where it is reflected.
     *
     * @return how many rays go on
     */
    static int shade(int pixels, float ambient, int last, float[] bodyColors, float[] lanes, int[] marks) {
        float lightRed = bodyColors[3 * Layout.LIGHT];
        float lightGreen = bodyColors[3 * Layout.LIGHT + 1];
        float lightBlue = bodyColors[3 * Layout.LIGHT + 2];
        int going = 0;
        for (int lane = 0; lane < pixels; lane++) {
            int hit = marks[Strip.HIT + lane];
            int surface = hit >= Layout.PLANE ? 1 : 0;
            float reflectivity = lanes[Strip.REFLECTIVITY + lane];
            float normalDotLight = lanes[Strip.NORMAL_DOT_LIGHT + lane];
            float visible = lanes[Strip.VISIBLE + lane];
            float throughput = surface != 0 ? lanes[Strip.THROUGHPUT + lane] : 0f;
            float lit = Shading.lit(ambient, normalDotLight, visible);
            float specular =
                    normalDotLight > 0f ? Shading.specular(reflectivity, lanes[Strip.POWER + lane], visible) : 0f;
            float mirror = last == 0 ? reflectivity / Layout.MAX_REFLECTIVITY : 0f;
            float matte = (1f - mirror) * lit;
            float passed = mirror * lit;
            int goes = surface & (passed > 0f ? 1 : 0);
            lanes[Strip.RED + lane] = lanes[Strip.RED + lane]
                    + throughput * (lightRed * specular + matte * lanes[Strip.ALBEDO_RED + lane]);
            lanes[Strip.GREEN + lane] = lanes[Strip.GREEN + lane]
                    + throughput * (lightGreen * specular + matte * lanes[Strip.ALBEDO_GREEN + lane]);
            lanes[Strip.BLUE + lane] = lanes[Strip.BLUE + lane]
                    + throughput * (lightBlue * specular + matte * lanes[Strip.ALBEDO_BLUE + lane]);
            lanes[Strip.THROUGHPUT + lane] = throughput * passed;
            marks[Strip.LEAVING + lane] = goes != 0 ? hit : Strip.FINISHED;
            going = going + goes;

            float normalX = lanes[Strip.NORMAL_X + lane];
            float normalY = lanes[Strip.NORMAL_Y + lane];
            float normalZ = lanes[Strip.NORMAL_Z + lane];
            float directionX = lanes[Strip.DIRECTION_X + lane];
            float directionY = lanes[Strip.DIRECTION_Y + lane];
            float directionZ = lanes[Strip.DIRECTION_Z + lane];
            float directionDotNormal = directionX * normalX + directionY * normalY + directionZ * normalZ;
            directionX = directionX - 2f * directionDotNormal * normalX;
            directionY = directionY - 2f * directionDotNormal * normalY;
            directionZ = directionZ - 2f * directionDotNormal * normalZ;
            float inverse =
                    KernelMath.inverseRoot(directionX * directionX + directionY * directionY + directionZ * directionZ);
            lanes[Strip.DIRECTION_X + lane] = directionX * inverse;
            lanes[Strip.DIRECTION_Y + lane] = directionY * inverse;
            lanes[Strip.DIRECTION_Z + lane] = directionZ * inverse;
            lanes[Strip.ORIGIN_X + lane] = lanes[Strip.POINT_X + lane];
            lanes[Strip.ORIGIN_Y + lane] = lanes[Strip.POINT_Y + lane];
            lanes[Strip.ORIGIN_Z + lane] = lanes[Strip.POINT_Z + lane];
        }
        return going;
    }
}
