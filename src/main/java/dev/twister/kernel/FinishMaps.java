package dev.twister.kernel;

/**
 * The finish of a surface, which {@link Layout#LOOK_FINISH} leads to, with its maps. Only with {@link Variant#FINISH}.
 */
final class FinishMaps {
    private static final float LEAST_SQUARE = 1e-30f;

    private FinishMaps() {}

    /**
     * Writes {@link Layout#FINISH}, {@link Layout#COAT_NORMAL}, and {@link Layout#GRAIN} at a right angle to the
     * normal, of a body that has a finish.
     *
     * @param path {@link Layout#FINISHED_PATH_LENGTH} floats, after {@link Surface#face} and before
     *     {@link NormalMap#apply}
     */
    static void find(
            float[] path,
            int body,
            float[] frame,
            float[] bodies,
            float[] looks,
            float[] meshes,
            float[] images,
            int variant) {
        int row = (int) looks[Layout.LOOK_STRIDE * body + Layout.LOOK_FINISH];
        if (row > 0) {
            copy(path, row, looks);
            float outward = NormalMap.outward(path, body, frame, variant);
            turn(path, outward);
            // A loop, so that the code that reads a map is there once.
            for (int place = Layout.FINISH_MAPS_COAT; place < Layout.FINISH_STRIDE; place += Layout.MAP_STRIDE) {
                int reads = place == Layout.FINISH_MAPS_COAT_NORMAL ? 0 : 1;
                if (reads != 0) {
                    if (SurfaceMaps.aim(path, row + place, body, frame, bodies, looks, meshes, variant) != 0) {
                        multiply(path, row, place, looks, images);
                    }
                }
            }
            NormalMap.writeTangent(
                    path, body, row + Layout.FINISH_MAPS_ANISOTROPY, frame, bodies, looks, meshes, variant);
            writeGrain(path);
            turn(path, outward);
            float normalX = path[Layout.NORMAL];
            float normalY = path[Layout.NORMAL + 1];
            float normalZ = path[Layout.NORMAL + 2];
            if (looks[row + Layout.FINISH_MAPS_COAT_NORMAL + Layout.MAP_WIDTH] > 0f) {
                NormalMap.turn(
                        path,
                        body,
                        row + Layout.FINISH_MAPS_COAT_NORMAL,
                        looks[row + Layout.FINISH_COAT_NORMAL_SCALE],
                        frame,
                        bodies,
                        looks,
                        meshes,
                        images,
                        variant);
            }
            writeCoatNormal(path);
            path[Layout.NORMAL] = normalX;
            path[Layout.NORMAL + 1] = normalY;
            path[Layout.NORMAL + 2] = normalZ;
        }
    }

    /** By loops of three, which compilers of devices unroll: then all places in the path are constants. */
    private static void copy(float[] path, int row, float[] looks) {
        copyThree(path, 0, row, looks);
        copyThree(path, 3, row, looks);
        copyThree(path, 6, row, looks);
        copyThree(path, 9, row, looks);
        copyThree(path, 12, row, looks);
        copyThree(path, 15, row, looks);
        path[Layout.FINISH + 18] = looks[row + 18];
        path[Layout.FINISH + 19] = looks[row + 19];
    }

    private static void copyThree(float[] path, int first, int row, float[] looks) {
        for (int number = 0; number < 3; number++) {
            path[Layout.FINISH + first + number] = looks[row + first + number];
        }
    }

    private static void turn(float[] path, float side) {
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.NORMAL + axis] = side * path[Layout.NORMAL + axis];
        }
    }

    private static void writeCoatNormal(float[] path) {
        float side = Facet.directionDot(path, Layout.NORMAL) > 0f ? -1f : 1f;
        for (int axis = 0; axis < 3; axis++) {
            path[Layout.COAT_NORMAL + axis] = side * path[Layout.NORMAL + axis];
        }
    }

    /**
     * Multiplies what a map varies by its color at {@link Layout#TEXEL}.
     *
     * @param row place of the finish in {@code looks}
     * @param place of the map in the row
     */
    private static void multiply(float[] path, int row, int place, float[] looks, float[] images) {
        float red = Texture.channel(path, row + place, 0, looks, images);
        float green = Texture.channel(path, row + place, 1, looks, images);
        float blue = Texture.channel(path, row + place, 2, looks, images);
        scale(path, Layout.FINISH_COAT, place == Layout.FINISH_MAPS_COAT ? red : 1f);
        scale(path, Layout.FINISH_COAT_ROUGHNESS, place == Layout.FINISH_MAPS_COAT_ROUGHNESS ? green : 1f);
        int sheen = place == Layout.FINISH_MAPS_SHEEN ? 1 : 0;
        scale(path, Layout.FINISH_SHEEN, sheen != 0 ? red : 1f);
        scale(path, Layout.FINISH_SHEEN + 1, sheen != 0 ? green : 1f);
        scale(path, Layout.FINISH_SHEEN + 2, sheen != 0 ? blue : 1f);
        scale(path, Layout.FINISH_SHEEN_ROUGHNESS, place == Layout.FINISH_MAPS_SHEEN_ROUGHNESS ? red : 1f);
        int grain = place == Layout.FINISH_MAPS_ANISOTROPY ? 1 : 0;
        scale(path, Layout.FINISH_ANISOTROPY, grain != 0 ? blue : 1f);
        turnGrain(path, grain != 0 ? 2f * red - 1f : 1f, grain != 0 ? 2f * green - 1f : 0f);
        float kept = (1f - path[Layout.SPECULAR_LOSS]) * red;
        path[Layout.SPECULAR_LOSS] = place == Layout.FINISH_MAPS_SPECULAR ? 1f - kept : path[Layout.SPECULAR_LOSS];
        int specular = place == Layout.FINISH_MAPS_SPECULAR_COLOR ? 1 : 0;
        scale(path, Layout.FINISH_SPECULAR_COLOR, specular != 0 ? red : 1f);
        scale(path, Layout.FINISH_SPECULAR_COLOR + 1, specular != 0 ? green : 1f);
        scale(path, Layout.FINISH_SPECULAR_COLOR + 2, specular != 0 ? blue : 1f);
        scale(path, Layout.FINISH_FILM, place == Layout.FINISH_MAPS_FILM ? red : 1f);
        float least = looks[row + Layout.FINISH_FILM_LEAST];
        float most = path[Layout.FINISH + Layout.FINISH_FILM_THICKNESS];
        path[Layout.FINISH + Layout.FINISH_FILM_THICKNESS] =
                place == Layout.FINISH_MAPS_FILM_THICKNESS ? least + green * (most - least) : most;
        scale(path, Layout.FINISH_THROUGH, place == Layout.FINISH_MAPS_THROUGH ? red : 1f);
        int through = place == Layout.FINISH_MAPS_THROUGH_COLOR ? 1 : 0;
        scale(path, Layout.FINISH_THROUGH_COLOR, through != 0 ? red : 1f);
        scale(path, Layout.FINISH_THROUGH_COLOR + 1, through != 0 ? green : 1f);
        scale(path, Layout.FINISH_THROUGH_COLOR + 2, through != 0 ? blue : 1f);
    }

    private static void scale(float[] path, int number, float factor) {
        path[Layout.FINISH + number] = path[Layout.FINISH + number] * factor;
    }

    /** Turns the angle of the grain by that of a vector, unless it has no direction. */
    private static void turnGrain(float[] path, float x, float y) {
        float squared = x * x + y * y;
        float inverse = KernelMath.inverseRoot(squared);
        float cosine = path[Layout.FINISH + Layout.FINISH_GRAIN_COSINE];
        float sine = path[Layout.FINISH + Layout.FINISH_GRAIN_SINE];
        int known = squared > LEAST_SQUARE ? 1 : 0;
        path[Layout.FINISH + Layout.FINISH_GRAIN_COSINE] = known != 0 ? (cosine * x - sine * y) * inverse : cosine;
        path[Layout.FINISH + Layout.FINISH_GRAIN_SINE] = known != 0 ? (sine * x + cosine * y) * inverse : sine;
    }

    /** Writes {@link Layout#GRAIN} by {@link Layout#TANGENT} and {@link Layout#UPWARD}. */
    private static void writeGrain(float[] path) {
        straighten(path, path[Layout.TANGENT], path[Layout.TANGENT + 1], path[Layout.TANGENT + 2]);
        float rightX = path[Layout.GRAIN];
        float rightY = path[Layout.GRAIN + 1];
        float rightZ = path[Layout.GRAIN + 2];
        float upX = path[Layout.NORMAL + 1] * rightZ - path[Layout.NORMAL + 2] * rightY;
        float upY = path[Layout.NORMAL + 2] * rightX - path[Layout.NORMAL] * rightZ;
        float upZ = path[Layout.NORMAL] * rightY - path[Layout.NORMAL + 1] * rightX;
        float side = upX * path[Layout.UPWARD] + upY * path[Layout.UPWARD + 1] + upZ * path[Layout.UPWARD + 2];
        float cosine = path[Layout.FINISH + Layout.FINISH_GRAIN_COSINE];
        float sine = path[Layout.FINISH + Layout.FINISH_GRAIN_SINE];
        float up = side < 0f ? -sine : sine;
        path[Layout.GRAIN] = cosine * rightX + up * upX;
        path[Layout.GRAIN + 1] = cosine * rightY + up * upY;
        path[Layout.GRAIN + 2] = cosine * rightZ + up * upZ;
    }

    /** Turns the grain to a right angle with the normal, after {@link NormalMap#apply}. */
    static void straighten(float[] path) {
        if (path[Layout.IS_FINISHED] > 0f) {
            straighten(path, path[Layout.GRAIN], path[Layout.GRAIN + 1], path[Layout.GRAIN + 2]);
        }
    }

    /** Writes the unit vector at a right angle to the normal that is nearest to a vector; any if that is along it. */
    private static void straighten(float[] path, float x, float y, float z) {
        float along = x * path[Layout.NORMAL] + y * path[Layout.NORMAL + 1] + z * path[Layout.NORMAL + 2];
        float acrossX = x - along * path[Layout.NORMAL];
        float acrossY = y - along * path[Layout.NORMAL + 1];
        float acrossZ = z - along * path[Layout.NORMAL + 2];
        float squared = acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ;
        float inverse = KernelMath.inverseRoot(squared);
        int known = squared > LEAST_SQUARE ? 1 : 0;
        TangentFrame.write(
                path, Layout.GRAIN, path[Layout.NORMAL], path[Layout.NORMAL + 1], path[Layout.NORMAL + 2], 1f, 0f, 0f);
        path[Layout.GRAIN] = known != 0 ? acrossX * inverse : path[Layout.GRAIN];
        path[Layout.GRAIN + 1] = known != 0 ? acrossY * inverse : path[Layout.GRAIN + 1];
        path[Layout.GRAIN + 2] = known != 0 ? acrossZ * inverse : path[Layout.GRAIN + 2];
    }
}
