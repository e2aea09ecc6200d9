package dev.twister.kernel;

/** The points where the rays of a strip meet the plane and spheres. */
final class StripSurface {
    private StripSurface() {}

    /** Looks the hit bodies up; lanes that have hit none take the plane's. */
    static void look(
            int pixels,
            float[] bodyPositions,
            float[] bodySizes,
            float[] bodyColors,
            float[] bodyReflectivities,
            float[] lanes,
            int[] marks) {
        for (int lane = 0; lane < pixels; lane++) {
            int body = Math.max(marks[Strip.HIT + lane], Layout.PLANE);
            lanes[Strip.CENTER_X + lane] = bodyPositions[3 * body];
            lanes[Strip.CENTER_Y + lane] = bodyPositions[3 * body + 1];
            lanes[Strip.CENTER_Z + lane] = bodyPositions[3 * body + 2];
            lanes[Strip.RADIUS + lane] = bodySizes[body];
            lanes[Strip.REFLECTIVITY + lane] = bodyReflectivities[body];
            lanes[Strip.ALBEDO_RED + lane] = bodyColors[3 * body];
            lanes[Strip.ALBEDO_GREEN + lane] = bodyColors[3 * body + 1];
            lanes[Strip.ALBEDO_BLUE + lane] = bodyColors[3 * body + 2];
        }
    }

    /** Finds point, normal, colour and the way to the light, and whether what hides the light would matter. */
    static void find(int pixels, float[] rayTracingProperties, float[] bodyPositions, float[] lanes, int[] marks) {
        float ambient = rayTracingProperties[Layout.AMBIENT];
        float oddRed = rayTracingProperties[Layout.PLANE_ODD_COLOR];
        float oddGreen = rayTracingProperties[Layout.PLANE_ODD_COLOR + 1];
        float oddBlue = rayTracingProperties[Layout.PLANE_ODD_COLOR + 2];
        float lightX = bodyPositions[3 * Layout.LIGHT];
        float lightY = bodyPositions[3 * Layout.LIGHT + 1];
        float lightZ = bodyPositions[3 * Layout.LIGHT + 2];
        for (int lane = 0; lane < pixels; lane++) {
            int hit = marks[Strip.HIT + lane];
            int surface = hit >= Layout.PLANE ? 1 : 0;
            int plane = hit <= Layout.PLANE ? 1 : 0;
            float distance = surface != 0 ? lanes[Strip.DISTANCE + lane] : 0f;
            float centerX = lanes[Strip.CENTER_X + lane];
            float centerY = lanes[Strip.CENTER_Y + lane];
            float centerZ = lanes[Strip.CENTER_Z + lane];
            float radius = lanes[Strip.RADIUS + lane];
            float reflectivity = lanes[Strip.REFLECTIVITY + lane];
            float red = lanes[Strip.ALBEDO_RED + lane];
            float green = lanes[Strip.ALBEDO_GREEN + lane];
            float blue = lanes[Strip.ALBEDO_BLUE + lane];
            float metX = lanes[Strip.ORIGIN_X + lane] + distance * lanes[Strip.DIRECTION_X + lane];
            float metY = lanes[Strip.ORIGIN_Y + lane] + distance * lanes[Strip.DIRECTION_Y + lane];
            float metZ = lanes[Strip.ORIGIN_Z + lane] + distance * lanes[Strip.DIRECTION_Z + lane];
            int odd = plane & (1 - Shading.isEvenSquare(metX, metZ));
            float outX = metX - centerX;
            float outY = metY - centerY;
            float outZ = metZ - centerZ;
            float normalInverse = KernelMath.inverseRoot(outX * outX + outY * outY + outZ * outZ);
            float normalX = plane != 0 ? 0f : outX * normalInverse;
            float normalY = plane != 0 ? 1f : outY * normalInverse;
            float normalZ = plane != 0 ? 0f : outZ * normalInverse;
            float pointX = plane != 0 ? metX : centerX + normalX * radius;
            float pointY = plane != 0 ? centerY : centerY + normalY * radius;
            float pointZ = plane != 0 ? metZ : centerZ + normalZ * radius;
            float toLightX = lightX - pointX;
            float toLightY = lightY - pointY;
            float toLightZ = lightZ - pointZ;
            float lightDistanceSquared = toLightX * toLightX + toLightY * toLightY + toLightZ * toLightZ;
            float lightInverse = KernelMath.inverseRoot(lightDistanceSquared);
            toLightX = toLightX * lightInverse;
            toLightY = toLightY * lightInverse;
            toLightZ = toLightZ * lightInverse;
            float normalDotLight = normalX * toLightX + normalY * toLightY + normalZ * toLightZ;
            int shadowMatters =
                    (normalDotLight > ambient ? 1 : 0) | ((normalDotLight > 0f ? 1 : 0) & (reflectivity > 0f ? 1 : 0));
            lanes[Strip.ALBEDO_RED + lane] = odd != 0 ? oddRed : red;
            lanes[Strip.ALBEDO_GREEN + lane] = odd != 0 ? oddGreen : green;
            lanes[Strip.ALBEDO_BLUE + lane] = odd != 0 ? oddBlue : blue;
            lanes[Strip.POINT_X + lane] = pointX;
            lanes[Strip.POINT_Y + lane] = pointY;
            lanes[Strip.POINT_Z + lane] = pointZ;
            lanes[Strip.NORMAL_X + lane] = normalX;
            lanes[Strip.NORMAL_Y + lane] = normalY;
            lanes[Strip.NORMAL_Z + lane] = normalZ;
            lanes[Strip.TO_LIGHT_X + lane] = toLightX;
            lanes[Strip.TO_LIGHT_Y + lane] = toLightY;
            lanes[Strip.TO_LIGHT_Z + lane] = toLightZ;
            lanes[Strip.LIGHT_DISTANCE + lane] = lightDistanceSquared * lightInverse;
            lanes[Strip.NORMAL_DOT_LIGHT + lane] = normalDotLight;
            marks[Strip.SHADED + lane] = surface & shadowMatters;
        }
    }
}
