package dev.twister.mesh.assembly;

import dev.twister.mesh.Affine;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.TriangleMesh;
import dev.twister.mesh.input.Bytes;
import dev.twister.scene.Material;
import dev.twister.scene.Vector3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SequencedMap;
import java.util.TreeMap;

/** Assembles the triangles of a file into meshes, one per material. */
public final class MeshAssembly {
    /**
     * The result.
     *
     * @param center what the positions are relative to
     * @param meshByMaterial meshes with at least one triangle, by the number of the material in ascending order
     * @param degenerateTriangles number of dropped triangles without area
     */
    public record Assembled(
            Vector3 center, SequencedMap<Integer, TriangleMesh> meshByMaterial, int degenerateTriangles) {
        /** The transform from the meshes' coordinates to the file's, in Twister's axes. */
        public Affine placement() {
            return Affine.moving(center);
        }

        /** A file with a single material. */
        public MeshFile file(String name, Bytes bytes, Material material) {
            if (meshByMaterial.isEmpty()) {
                throw noTriangles(bytes, degenerateTriangles);
            }
            return file(name, material);
        }

        /** As above, of at least one triangle with an area. */
        public MeshFile file(String name, Material material) {
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
    private final List<FloatList> textureCoordinates = new ArrayList<>();
    private final FloatList colors = new FloatList();
    private final FloatList tangents = new FloatList();
    private boolean smooth;
    private boolean textured;

    private MeshAssembly(TriangleSoup soup) {
        this.soup = soup;
        for (int set = 0; set <= soup.furtherCoordinates.size(); set++) {
            textureCoordinates.add(new FloatList());
        }
    }

    public static MeshException noTriangles(Bytes bytes, int degenerate) {
        return bytes.failure(
                degenerate == 0 ? "holds no triangles" : "holds no triangles but " + degenerate + " without an area");
    }

    /**
     * Assembles the meshes. All numbers in the soup must have been checked; the soup is modified and must not be
     * reused.
     */
    public static Assembled assemble(TriangleSoup soup, Axes axes, double smoothDegrees) {
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
        for (int i = from; i < to && !textured; i++) {
            textured = soup.textureAt(3 * triangles[i]) != TriangleSoup.NONE;
        }
        // Missing normals have been generated, so either all corners have one or none.
        smooth = soup.normalAt(3 * triangles[from]) != TriangleSoup.NONE;
        boolean alone = soup.hasOneNumbering() && soup.colorOf.size() == 0 && soup.materialOf.size() == 0;
        int[] corners = alone ? renumbered(triangles) : unified(triangles, from, to);
        FloatList coordinates = textureCoordinates.getFirst();
        for (FloatList further : textureCoordinates.subList(1, textureCoordinates.size())) {
            for (int i = 0; i < further.size(); i++) {
                coordinates.add(further.get(i));
            }
        }
        return new TriangleMesh(
                positions.toArray(),
                normals.toArray(),
                coordinates.toArray(),
                colors.toArray(),
                tangents.toArray(),
                corners);
    }

    /** Keeps the file's vertices except unused ones. */
    private int[] renumbered(int[] triangles) {
        int[] numbers = new int[soup.vertices()];
        int[] corners = new int[3 * triangles.length];
        for (int corner = 0; corner < corners.length; corner++) {
            int old = soup.positionOf.get(corner);
            if (numbers[old] == 0) {
                addVertex(old, smooth ? old : TriangleSoup.NONE, textured ? old : TriangleSoup.NONE, old);
                numbers[old] = positions.size() / 3;
            }
            corners[corner] = numbers[old] - 1;
        }
        return corners;
    }

    /** Creates a vertex for each distinct combination of position, normal, texture coordinates and color. */
    private int[] unified(int[] triangles, int from, int to) {
        int[] corners = new int[3 * (to - from)];
        int[] table = new int[TableHash.tableSize(corners.length)];
        int mask = table.length - 1;
        IntList keys = new IntList(corners.length);
        for (int i = 0; i < corners.length; i++) {
            int corner = 3 * triangles[from + i / 3] + i % 3;
            int position = soup.positionOf.get(corner);
            int normal = smooth ? soup.normalAt(corner) : TriangleSoup.NONE;
            int texture = textured ? soup.textureAt(corner) : TriangleSoup.NONE;
            int color = soup.colorAt(corner);
            // Most positions have one vertex, found where neighbors are; the others are scattered over the table.
            int slot = position & mask;
            if (table[slot] > 0 && !isKey(keys, 4 * (table[slot] - 1), position, normal, texture, color)) {
                slot = TableHash.of(position, normal, 31 * color + texture) & mask;
            }
            while (table[slot] > 0 && !isKey(keys, 4 * (table[slot] - 1), position, normal, texture, color)) {
                slot = slot + 1 & mask;
            }
            if (table[slot] == 0) {
                keys.add(position);
                keys.add(normal);
                keys.add(texture);
                keys.add(color);
                addVertex(position, normal, texture, color);
                table[slot] = keys.size() / 4;
            }
            corners[i] = table[slot] - 1;
        }
        return corners;
    }

    private static boolean isKey(IntList keys, int at, int position, int normal, int texture, int color) {
        return keys.get(at) == position
                && keys.get(at + 1) == normal
                && keys.get(at + 2) == texture
                && keys.get(at + 3) == color;
    }

    private void addVertex(int position, int normal, int texture, int color) {
        if (soup.traced) {
            soup.vertexPositions.add(position);
            soup.vertexNormals.add(normal);
        }
        for (int axis = 0; axis < 3; axis++) {
            positions.add(soup.places.get(3 * position + axis));
        }
        for (int axis = 0; smooth && axis < 3; axis++) {
            normals.add(soup.normals.get(3 * normal + axis));
        }
        for (int set = 0; textured && set < textureCoordinates.size(); set++) {
            FloatList coordinates = set == 0 ? soup.textureCoordinates : soup.furtherCoordinates.get(set - 1);
            for (int axis = 0; axis < 2; axis++) {
                textureCoordinates.get(set).add(texture == TriangleSoup.NONE ? 0 : coordinates.get(2 * texture + axis));
            }
        }
        for (int channel = 0; channel < 4 && soup.colors.size() > 0; channel++) {
            colors.add(color == TriangleSoup.NONE ? 1 : soup.colors.get(4 * color + channel));
        }
        for (int axis = 0; axis < 3 && soup.tangents.size() > 0; axis++) {
            tangents.add(soup.tangents.get(3 * position + axis));
        }
        if (soup.tangents.size() > 0) {
            tangents.add(soup.tangentSigns.get(position));
        }
    }
}
