package dev.twister.lanes;

/**
 * One method for each construct of the kernel's Java. All have the same parameters; places in arrays are from 0 to 31.
 */
final class Constructs {
    private static final float SCALE = 0x1p-4f;
    private static final int STEP = 2 * 3;

    private Constructs() {}

    static float arithmetic(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        path[0] = -path[1] * x + (a - b) / SCALE;
        path[2] = path[0] / path[3] - STEP * a;
        path[4] = (a ^ b) + (a & 7) - (b | 3) + (a << 3) + (a >> 1) - a * b + 4 * a;
        return path[2] - x;
    }

    @SuppressWarnings("NarrowCalculation") // divides ints on purpose
    static int divisions(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        int large = 1000 * a + b;
        path[0] = large / 7;
        path[1] = large % 7 + a / 2 - b % 2;
        return (a + b) / 16 % 3;
    }

    static int comparisons(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        int flags = (path[0] < x ? 1 : 0) & (path[1] >= 0f ? 1 : 0);
        int others = (a == b ? 1 : 0) | (a > 3 ? 1 : 0);
        int last = (x != path[2] ? 1 : 0) & (b <= 9 ? 1 : 0) & (1 - others);
        path[3] = flags;
        path[4] = flags + others;
        return (flags | last) != 0 ? 2 + flags : others;
    }

    static float shortcuts(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float found = a > 3 && frame[a] > x ? 1f : 2f;
        return b < 5 || frame[b + 1] < path[0] ? found : -found;
    }

    static float choices(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float first = x > 0f ? frame[a] : frame[31 - b];
        int second = x > first ? a : b + 1;
        return (second > 4 ? second : 0) + (frame[3] > 0f ? first : -x);
    }

    static float functions(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        path[0] = Math.max(Math.min(x, path[1]), -1f);
        path[2] = (float) Math.sqrt(Math.abs(path[3]));
        path[4] = Math.max(a, b) - Math.min(a, 5) + Math.abs(a - b);
        path[5] = (int) (path[6] * 100f) + Math.abs(frame[2]);
        return path[0] + path[5];
    }

    static float loads(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float sum = frame[a] + frame[a / 2 + 1] - frame[5] * frame[31 - a];
        return sum + scratch[b] - scratch[7] + scratch[b / 2 + 3];
    }

    static void stores(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        scratch[a] = x;
        scratch[a / 2 + 1] = scratch[a] + scratch[b];
        scratch[9] = path[0];
        path[0] = scratch[a];
    }

    static float smallIfs(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float y = x;
        int flag = 0;
        if (path[0] > x) {
            y = y + 1f;
            path[1] = y;
            flag = 1;
        }
        if (flag != 0) {
            path[2] = path[1];
        } else {
            path[2] = 3f;
            y = -y;
        }
        return y + path[2];
    }

    static float largeIfs(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float y = x;
        int count = 0;
        if (a > b) {
            y = frame[a] + path[0];
            path[1] = y;
            if (frame[b] > 0f) {
                y = y * frame[a - b];
                count = a;
                path[2] = path[1] + scratch[a];
            } else {
                path[1] = -y;
            }
        } else {
            count = b;
            scratch[b] = y;
        }
        return y + count + path[1];
    }

    static float uniformIfs(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float y = x;
        int place = 1;
        if (frame[0] > 0f) {
            place = (int) (frame[1] * frame[1]);
            path[0] = y;
        } else {
            y = y + path[0];
        }
        if ((variant & 2) != 0) {
            y = y * frame[a];
        }
        if ((variant >> 2) == 1) {
            path[1] = y;
        }
        return y + place;
    }

    static float whileLoops(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        int left = a;
        float sum = 0f;
        float before = 0f;
        while (left > 0) {
            float now = frame[left] * x;
            if (now > 0f) {
                sum = sum + now - before;
                path[1] = path[1] + 1f;
            }
            before = now;
            left = left - 1 - (b & 1);
        }
        path[0] = before;
        return sum;
    }

    static float nestedLoops(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        int low = 0;
        int high = b;
        int trips = 0;
        while (low < high) {
            int middle = (low + high) / 2;
            int goesOn = 1;
            for (int k = middle; ((k < 31 ? 1 : 0) & goesOn) != 0; k++) {
                goesOn = frame[k] > x ? 1 : 0;
                trips++;
            }
            high = goesOn != 0 ? high - 1 : middle;
            low = goesOn != 0 ? middle + 1 : low;
        }
        return trips + low;
    }

    static float exchangedInLoops(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float first = x;
        float second = path[0];
        for (int k = 0; k < a; k++) {
            float old = first;
            first = second;
            second = old + frame[k];
        }
        return first - 2f * second;
    }

    static float uniformLoops(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float sum = 0f;
        int nearest = -1;
        for (int k = 4; k < 4 + (int) (frame[0] * frame[0]); k++) {
            if (frame[k] < x) {
                sum += frame[k];
                nearest = k;
            }
            path[0] = path[0] + sum;
        }
        return nearest + sum;
    }

    static float unrolledLoops(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        float sum = 0f;
        for (int axis = 0; axis < 3; axis++) {
            path[3 + axis] = path[axis] * x;
            sum += path[3 + axis];
        }
        for (int axis = 2; axis > 0; axis--) {
            sum += path[axis];
        }
        return sum;
    }

    static float calls(float[] path, float[] scratch, float[] frame, int a, int b, float x, int variant) {
        int larger = larger(a, b);
        store(path, 2, mean(x, frame[larger]));
        return larger > 3 ? mean(path[2], a) : Constructs.larger(b, 1);
    }

    private static int larger(int a, int b) {
        return a > b ? a : b;
    }

    private static float mean(float a, float b) {
        return 0.5f * (a + b);
    }

    private static void store(float[] path, int place, float value) {
        path[place] = value;
    }
}
