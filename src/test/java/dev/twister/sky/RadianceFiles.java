package dev.twister.sky;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Creates Radiance files in every coding and orientation, simply and without regard to size. */
public final class RadianceFiles {
    public enum Coding {
        FLAT,
        OLD_RUNS,
        NEW_RUNS
    }

    private RadianceFiles() {}

    /**
     * Encodes the texels of the upright picture.
     *
     * @param rgbe four bytes per texel, in row-major order from the top left
     * @param orientation for example "-Y +X"
     */
    public static byte[] file(String header, String orientation, int width, int height, byte[] rgbe, Coding coding) {
        boolean byColumns = orientation.charAt(1) == 'X';
        int slow = byColumns ? width : height;
        int fast = byColumns ? height : width;
        String[] axes = orientation.split(" ", -1);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(ascii(header + "\n" + axes[0] + " " + slow + " " + axes[1] + " " + fast + "\n"));
        boolean right = orientation.contains("+X");
        boolean down = orientation.contains("-Y");
        for (int line = 0; line < slow; line++) {
            byte[] scanline = new byte[4 * fast];
            for (int place = 0; place < fast; place++) {
                int along = byColumns ? line : place;
                int across = byColumns ? place : line;
                int x = right ? along : width - 1 - along;
                int y = down ? across : height - 1 - across;
                System.arraycopy(rgbe, 4 * (y * width + x), scanline, 4 * place, 4);
            }
            switch (coding) {
                case FLAT -> out.writeBytes(scanline);
                case OLD_RUNS -> oldRuns(scanline, out);
                case NEW_RUNS -> newRuns(scanline, out);
            }
        }
        return out.toByteArray();
    }

    public static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static void oldRuns(byte[] scanline, ByteArrayOutputStream out) {
        int texels = scanline.length / 4;
        int at = 0;
        while (at < texels) {
            out.write(scanline, 4 * at, 4);
            int repeats = 0;
            while (at + 1 + repeats < texels && sameTexel(scanline, at, at + 1 + repeats)) {
                repeats++;
            }
            for (int rest = repeats; rest > 0; rest >>= 8) {
                out.writeBytes(new byte[] {1, 1, 1, (byte) rest});
            }
            at += 1 + repeats;
        }
    }

    private static boolean sameTexel(byte[] scanline, int one, int other) {
        for (int i = 0; i < 4; i++) {
            if (scanline[4 * one + i] != scanline[4 * other + i]) {
                return false;
            }
        }
        return true;
    }

    private static void newRuns(byte[] scanline, ByteArrayOutputStream out) {
        int texels = scanline.length / 4;
        out.writeBytes(new byte[] {2, 2, (byte) (texels >> 8), (byte) texels});
        for (int component = 0; component < 4; component++) {
            int at = 0;
            while (at < texels) {
                byte value = scanline[4 * at + component];
                int run = 1;
                while (run < 127 && at + run < texels && scanline[4 * (at + run) + component] == value) {
                    run++;
                }
                // Writes single values as literals, so that both kinds of code occur.
                out.write(run == 1 ? 1 : 128 + run);
                out.write(value);
                at += run;
            }
        }
    }
}
