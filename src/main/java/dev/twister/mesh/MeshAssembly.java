package dev.twister.mesh;

import dev.twister.scene.Material;
import dev.twister.scene.Vector3;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SequencedMap;
import java.util.TreeMap;

/** Assembles the triangles of a file into meshes, one per material. */
final class MeshAssembly {
    /**
     * The result.
     *
     * @param center what the positions are relative to
     * @param meshByMaterial meshes with at least one triangle, by the number of the material in ascending order
     * @param degenerateTriangles number of dropped triangles without area
     */
    record Assembled(Vector3 center, SequencedMap<Integer, TriangleMesh> meshByMaterial, int degenerateTriangles) {
        /** The transform from the meshes' coordinates to the file's, in Twister's axes. */
        Affine placement() {
            return Affine.moving(center);
        }

        /** A file with a single material. */
        MeshFile file(String name, Bytes bytes, Material material) {
            if (meshByMaterial.isEmpty()) {
                throw noTriangles(bytes, degenerateTriangles);
            }
            return new MeshFile(
                    List.copyOf(meshByMaterial.values()),
                    List.of(new MeshPart(name, 0, placement(), material)),
                    Map.of(),
                    degenerateTriangles);
        }
    }

    private final TriangleSoup soup;
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList textureCoordinates = new FloatList();

    private MeshAssembly(TriangleSoup soup) {
        this.soup = soup;
    }

    static MeshException noTriangles(Bytes bytes, int degenerate) {
        return bytes.failure(
                degenerate == 0 ? "holds no triangles" : "holds no triangles but " + degenerate + " without an area");
    }

    /**
     * Assembles the meshes. All numbers in the soup must have been checked; the soup is modified and must not be
     * reused.
     */
    static Assembled assemble(TriangleSoup soup, Axes axes, double smoothDegrees) {
        Vector3 center = axes.turned(soup.center());
        soup.turn(axes);
        int degenerate = soup.dropDegenerate();
        MissingNormals.make(soup, smoothDegrees);
        SequencedMap<Integer, TriangleMesh> meshes = new TreeMap<>();
        if (soup.triangles() > 0 && soup.materialOf.size() == 0) {
            int[] all = new int[soup.triangles()];
            Arrays.setAll(all, triangle -> triangle);
            meshes.put(0, new MeshAssembly(soup).mesh(all, 0, all.length));
        } else if (soup.triangles() > 0) {
            byMaterial(soup, meshes);
        }
        return new Assembled(center, meshes, degenerate);
    }

    private static void byMaterial(TriangleSoup soup, SequencedMap<Integer, TriangleMesh> meshes) {
        int materials = 0;
        for (int triangle = 0; triangle < soup.triangles(); triangle++) {
            materials = Math.max(materials, soup.materialAt(triangle) + 1);
        }
        int[] ends = new int[materials + 1];
        for (int triangle = 0; triangle < soup.triangles(); triangle++) {
            ends[soup.materialAt(triangle) + 1]++;
        }
        Arrays.parallelPrefix(ends, Integer::sum);
        int[] starts = ends.clone();
        int[] sorted = new int[soup.triangles()];
        for (int triangle = 0; triangle < soup.triangles(); triangle++) {
            sorted[starts[soup.materialAt(triangle)]++] = triangle;
        }
        for (int material = 0; material < materials; material++) {
            if (ends[material + 1] > ends[material]) {
                meshes.put(material, new MeshAssembly(soup).mesh(sorted, ends[material], ends[material + 1]));
            }
        }
    }

    private TriangleMesh mesh(int[] triangles, int from, int to) {
        boolean textured = false;
        for (int i = from; i < to && !textured; i++) {
            textured = soup.textureAt(3 * triangles[i]) != TriangleSoup.NONE;
        }
        // Missing normals have been generated, so either all corners have one or none.
        boolean smooth = soup.normalAt(3 * triangles[from]) != TriangleSoup.NONE;
        boolean alone = soup.hasOneNumbering() && soup.materialOf.size() == 0;
        int[] corners =
                alone ? renumbered(triangles, smooth, textured) : unified(triangles, from, to, smooth, textured);
        return new TriangleMesh(positions.toArray(), normals.toArray(), textureCoordinates.toArray(), corners);
    }

    /** Keeps the file's vertices except unused ones. */
    private int[] renumbered(int[] triangles, boolean smooth, boolean textured) {
        int[] numbers = new int[soup.vertices()];
        int[] corners = new int[3 * triangles.length];
        for (int corner = 0; corner < corners.length; corner++) {
            int old = soup.positionOf.get(corner);
            if (numbers[old] == 0) {
                addVertex(old, smooth ? old : TriangleSoup.NONE, textured ? old : TriangleSoup.NONE, smooth, textured);
                numbers[old] = positions.size() / 3;
            }
            corners[corner] = numbers[old] - 1;
        }
        return corners;
    }

    /** Creates a vertex for each distinct combination of position, normal and texture coordinates. */
    private int[] unified(int[] triangles, int from, int to, boolean smooth, boolean textured) {
        int[] corners = new int[3 * (to - from)];
        int[] table = new int[TableHash.tableSize(corners.length)];
        int mask = table.length - 1;
        IntList keys = new IntList(corners.length);
        for (int i = 0; i < corners.length; i++) {
            int corner = 3 * triangles[from + i / 3] + i % 3;
            int position = soup.positionOf.get(corner);
            int normal = smooth ? soup.normalAt(corner) : TriangleSoup.NONE;
            int texture = textured ? soup.textureAt(corner) : TriangleSoup.NONE;
            int slot = TableHash.of(position, normal, texture) & mask;
            while (table[slot] > 0 && !isKey(keys, 3 * (table[slot] - 1), position, normal, texture)) {
                slot = slot + 1 & mask;
            }
            if (table[slot] == 0) {
                keys.add(position);
                keys.add(normal);
                keys.add(texture);
                addVertex(position, normal, texture, smooth, textured);
                table[slot] = keys.size() / 3;
            }
            corners[i] = table[slot] - 1;
        }
        return corners;
    }

    private static boolean isKey(IntList keys, int at, int position, int normal, int texture) {
        return keys.get(at) == position && keys.get(at + 1) == normal && keys.get(at + 2) == texture;
    }

    private void addVertex(int position, int normal, int texture, boolean smooth, boolean textured) {
        for (int axis = 0; axis < 3; axis++) {
            positions.add(soup.places.get(3 * position + axis));
        }
        for (int axis = 0; smooth && axis < 3; axis++) {
            normals.add(soup.normals.get(3 * normal + axis));
        }
        for (int axis = 0; textured && axis < 2; axis++) {
            textureCoordinates.add(texture == TriangleSoup.NONE ? 0 : soup.textureCoordinates.get(2 * texture + axis));
        }
    }
}
