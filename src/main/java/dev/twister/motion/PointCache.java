package dev.twister.motion;

import dev.twister.files.WholeFile;
import dev.twister.kernel.Layout;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Writes point caches ({@code .pc2}) for Blender and 3ds Max: the centers of the spheres per frame, in the scene's
 * coordinates, as floats. A sphere that is not poured yet is where the motion file puts it.
 */
public final class PointCache {
    private static final String MAGIC = "POINTCACHE2\0";
    private static final int VERSION = 1;

    private PointCache() {}

    /**
     * Writes some frames of a motion; on failure no file is left.
     *
     * @throws IOException if a frame is not in the motion, or as for {@link WholeFile#write}
     */
    public static void write(Path file, MotionFile motion, int firstFrame, int lastFrame) throws IOException {
        int spheres = motion.bodies() - Layout.FIRST_SPHERE;
        double[] origin = {
            motion.origin().x(), motion.origin().y(), motion.origin().z()
        };
        WholeFile.write(file, out -> {
            ByteBuffer header = ByteBuffer.allocate(MAGIC.length() + 5 * Integer.BYTES);
            header.order(ByteOrder.LITTLE_ENDIAN).put(MAGIC.getBytes(StandardCharsets.US_ASCII));
            // First frame, and samples per frame.
            header.putInt(VERSION).putInt(spheres).putFloat(firstFrame).putFloat(1);
            out.write(header.putInt(lastFrame - firstFrame + 1).array());
            ByteBuffer points = ByteBuffer.allocate(3 * Float.BYTES * spheres).order(ByteOrder.LITTLE_ENDIAN);
            for (int number = firstFrame; number <= lastFrame; number++) {
                float[] positions = motion.frame(number).positions();
                for (int i = 0; i < 3 * spheres; i++) {
                    points.putFloat((float) (positions[3 * Layout.FIRST_SPHERE + i] + origin[i % 3]));
                }
                out.write(points.array());
                points.clear();
            }
        });
    }
}
