package dev.twister.mesh.meshopt;

/** Decodes vertex numbers (modes TRIANGLES and INDICES of {@code EXT_meshopt_compression}). */
public final class MeshoptIndices {
    private static final int TRIANGLES = 0xe1;
    private static final int SEQUENCE = 0xd1;
    private static final int EDGES = 32;
    private static final int VERTICES = 16;

    private final byte[] source;
    private final int[] target;
    private final int[] edges = new int[EDGES];
    private final int[] vertices = new int[VERTICES];
    private int nextEdge;
    private int nextVertex;
    private int at;
    private int next;
    private int last;

    private MeshoptIndices(byte[] source, int count, int at) {
        this.source = source;
        this.target = new int[count];
        this.at = at;
    }

    /**
     * The corners of triangles.
     *
     * @param count a multiple of 3
     * @throws IndexOutOfBoundsException if the bytes are damaged
     */
    public static int[] triangles(byte[] source, int count) {
        check(source, TRIANGLES);
        MeshoptIndices indices = new MeshoptIndices(source, count, 1 + count / 3);
        for (int triangle = 0; triangle < count / 3; triangle++) {
            indices.readTriangle(triangle, source[1 + triangle] & 0xff);
        }
        return indices.target;
    }

    /**
     * Any numbers.
     *
     * @throws IndexOutOfBoundsException if the bytes are damaged
     */
    public static int[] sequence(byte[] source, int count) {
        check(source, SEQUENCE);
        MeshoptIndices indices = new MeshoptIndices(source, count, 1);
        int[] bases = new int[2];
        for (int i = 0; i < count; i++) {
            int value = indices.number();
            bases[value & 1] += MeshoptVertices.signed(value >>> 1);
            indices.target[i] = bases[value & 1];
        }
        return indices.target;
    }

    private static void check(byte[] source, int header) {
        if ((source[0] & 0xff) != header) {
            throw new IndexOutOfBoundsException("unknown header");
        }
    }

    private void readTriangle(int triangle, int code) {
        int edge = code >> 4;
        int third = code & 0xf;
        if (edge < 0xf) {
            int a = edges[(nextEdge - 1 - 2 * edge) & (EDGES - 1)];
            int b = edges[(nextEdge - 2 - 2 * edge) & (EDGES - 1)];
            int c = thirdCorner(third);
            put(triangle, a, b, c);
            addEdge(b, c);
            addEdge(c, a);
        } else {
            readFreeTriangle(triangle, third);
        }
    }

    private int thirdCorner(int code) {
        if (code > 0 && code < 0xd) {
            return vertex(code);
        }
        int corner = switch (code) {
            case 0 -> next++;
            case 0xd -> --last;
            case 0xe -> ++last;
            default -> relative();
        };
        addVertex(corner);
        return corner;
    }

    /** One that shares no edge with a recent triangle. */
    private void readFreeTriangle(int triangle, int code) {
        boolean tabled = code < 0xe;
        int others = (tabled ? source[source.length - 16 + code] : source[at++]) & 0xff;
        if (!tabled && others == 0) {
            next = 0;
        }
        int a = code == 0xf ? relative() : next++;
        int second = others >> 4;
        int third = others & 0xf;
        int b = corner(second, tabled);
        int c = corner(third, tabled);
        addVertex(a);
        if (isNew(second, tabled)) {
            addVertex(b);
        }
        if (isNew(third, tabled)) {
            addVertex(c);
        }
        put(triangle, a, b, c);
        addEdge(a, b);
        addEdge(b, c);
        addEdge(c, a);
    }

    private int corner(int code, boolean tabled) {
        if (code == 0) {
            return next++;
        }
        return isNew(code, tabled) ? relative() : vertex(code - 1);
    }

    private static boolean isNew(int code, boolean tabled) {
        return code == 0 || (code == 0xf && !tabled);
    }

    private int relative() {
        last += MeshoptVertices.signed(number());
        return last;
    }

    /** A number of seven bits per byte, the lowest first. */
    private int number() {
        int value = 0;
        int shift = 0;
        int part;
        do {
            part = source[at++];
            value |= (part & 0x7f) << shift;
            shift += 7;
        } while (part < 0 && shift < Integer.SIZE);
        return value;
    }

    /** The vertex that was added some time ago, 0 for the last. */
    private int vertex(int ago) {
        return vertices[(nextVertex - 1 - ago) & (VERTICES - 1)];
    }

    private void addVertex(int vertex) {
        vertices[nextVertex] = vertex;
        nextVertex = (nextVertex + 1) & (VERTICES - 1);
    }

    private void addEdge(int from, int to) {
        edges[nextEdge] = from;
        edges[nextEdge + 1] = to;
        nextEdge = (nextEdge + 2) & (EDGES - 1);
    }

    private void put(int triangle, int a, int b, int c) {
        target[3 * triangle] = a;
        target[3 * triangle + 1] = b;
        target[3 * triangle + 2] = c;
    }
}
