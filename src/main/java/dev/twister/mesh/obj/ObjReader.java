package dev.twister.mesh.obj;

import dev.twister.files.GitLfs;
import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.mesh.MeshException;
import dev.twister.mesh.MeshFile;
import dev.twister.mesh.MeshPart;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.assembly.FloatList;
import dev.twister.mesh.assembly.IntList;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.assembly.PolygonCutter;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.PathsBeside;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextCursor;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Material;
import dev.twister.scene.SrgbCurve;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SequencedMap;

/** Reads OBJ files and the MTL files that they refer to. */
public final class ObjReader {
    private static final int MAX_MATERIALS = 10_000;
    private static final int MAX_LIBRARIES = 100;
    private static final int MAX_LIBRARY_BYTES = 1 << 26;

    private final Path file;
    private final Bytes bytes;
    private final double smoothDegrees;
    private final Warnings warnings;
    private final TextCursor text;
    private final TriangleSoup soup = new TriangleSoup(0, 0);
    private final PolygonCutter cutter = new PolygonCutter();
    private final IntList polygon = new IntList();
    private final IntList polygonNormals = new IntList();
    private final IntList polygonTextures = new IntList();
    private final SequencedMap<String, Integer> numberByMaterial = new LinkedHashMap<>();
    private final Map<String, Material> defined = new HashMap<>();
    private final ObjColors colors = new ObjColors();
    private final MtlLayouts layouts = new MtlLayouts();
    private int libraries;
    private int material;

    public ObjReader(Path file, Bytes bytes, double smoothDegrees, Warnings warnings) {
        this.file = file;
        this.bytes = bytes;
        this.smoothDegrees = smoothDegrees;
        this.warnings = warnings;
        this.text = new TextCursor(bytes);
        numberByMaterial.put("", 0);
    }

    public MeshFile read() throws IOException {
        text.skipByteOrderMark();
        while (!text.atEnd()) {
            if (!text.atLineEnd()) {
                readLine(text.word());
            }
            text.skipLine();
        }
        colors.addTo(soup);
        layouts.addTo(soup);
        soup.warnOfUnusable(warnings);
        MeshAssembly.Assembled assembled = MeshAssembly.assemble(soup, Axes.Y_UP, smoothDegrees);
        if (assembled.meshByMaterial().isEmpty()) {
            throw MeshAssembly.noTriangles(bytes, assembled.degenerateTriangles());
        }
        List<String> names = List.copyOf(numberByMaterial.keySet());
        List<MeshPart> parts = new ArrayList<>();
        for (int number : assembled.meshByMaterial().keySet()) {
            String name = names.get(number);
            parts.add(new MeshPart(name, parts.size(), assembled.placement(), material(name)));
        }
        return new MeshFile(
                List.copyOf(assembled.meshByMaterial().values()), parts, Map.of(), assembled.degenerateTriangles());
    }

    private Material material(String name) {
        if (!name.isEmpty() && !defined.containsKey(name)) {
            warnings.add("material " + QuotedText.text(name) + " is not defined; rendered matte white");
        }
        return defined.getOrDefault(name, Material.DEFAULT);
    }

    private void readLine(String keyword) throws IOException {
        switch (keyword) {
            case "v" -> readPosition();
            case "vn" -> soup.normal(text.number(), text.number(), text.number());
            case "vt" -> readTextureCoordinates();
            case "f", "fo" -> readFace();
            case "usemtl" -> useMaterial(text.rest());
            case "mtllib" -> readLibraries(text.rest());
            // Groups, names and smoothing groups are ignored: normals, or the smoothing angle, decide what is smooth.
            case "g", "o", "s", "mg" -> {}
            case "p", "l" -> warnings.add("there are points or lines; not read");
            default -> {
                if (keyword.indexOf('\0') >= 0) {
                    throw text.failure("bytes of 0; expected text in ASCII or UTF-8");
                }
                warnings.add(QuotedText.text(keyword) + " is not read");
            }
        }
    }

    private void readPosition() throws IOException {
        double x = text.number();
        double y = text.number();
        double z = text.number();
        if (MeshLimits.areCoordinates(x, y, z)) {
            soup.position(x, y, z);
        } else {
            soup.missingPosition();
        }
        colors.read(text, soup.vertices());
        if (soup.vertices() > MeshLimits.VERTICES) {
            throw text.failure("more than " + MeshLimits.VERTICES + " vertices");
        }
    }

    private void readTextureCoordinates() throws IOException {
        double u = text.number();
        soup.textureCoordinates(u, text.atLineEnd() ? 1 : 1 - text.number());
    }

    private void readFace() throws IOException {
        polygon.cut(0);
        polygonNormals.cut(0);
        polygonTextures.cut(0);
        while (!text.atLineEnd()) {
            if (polygon.size() == MeshLimits.POLYGON_CORNERS) {
                throw text.failure("a face of more than " + MeshLimits.POLYGON_CORNERS + " corners; triangulate it");
            }
            readCorner();
        }
        int count = polygon.size();
        if (count < 3) {
            warnings.add("there are faces of fewer than 3 corners; not read");
            return;
        }
        IntList cut = cutter.cut(soup.positions, polygon, count);
        if (cutter.isExhausted()) {
            throw text.failure(PolygonCutter.EXHAUSTED);
        }
        for (int i = 0; i < cut.size(); i++) {
            int corner = cut.get(i);
            soup.corner(polygon.get(corner), polygonNormals.get(corner), polygonTextures.get(corner));
        }
        for (int i = 0; i < cut.size(); i += 3) {
            soup.materialOf.add(material);
        }
        if (soup.triangles() > MeshLimits.TRIANGLES) {
            throw text.failure(MeshLimits.tooManyTriangles(soup.triangles()));
        }
    }

    /** Reads a corner in one of the forms {@code 1}, {@code 1/2}, {@code 1//3} or {@code 1/2/3}. */
    private void readCorner() throws IOException {
        polygon.add(position());
        int texture = TriangleSoup.NONE;
        int normal = TriangleSoup.NONE;
        if (text.skip('/')) {
            if (text.atInteger()) {
                texture = index(soup.textureCoordinates.size() / 2);
            }
            if (text.skip('/') && text.atInteger()) {
                normal = index(soup.normals.size() / 3);
            }
        }
        if (!text.atWordEnd()) {
            throw text.unexpected("a corner like 1, 1/2, 1//3 or 1/2/3");
        }
        polygonTextures.add(texture);
        polygonNormals.add(normal);
    }

    private int position() throws IOException {
        int count = soup.vertices();
        long index = text.integer("the number of a vertex");
        int position = fromStart(index, count);
        if (position == TriangleSoup.NONE) {
            throw text.failure("vertex " + index + " is not there; "
                    + (count == 0 ? "there are none above this line" : "above this line there are 1 to " + count));
        }
        return position;
    }

    /** The index of a normal or of texture coordinates; some programs refer to missing ones. */
    private int index(int count) throws IOException {
        int index = fromStart(text.integer("a number"), count);
        if (index == TriangleSoup.NONE) {
            warnings.add("corners have normals or texture coordinates that are not there; read without them");
        }
        return index;
    }

    /** Converts a 1-based index, or a negative index from the end, to a 0-based one. */
    private static int fromStart(long index, int count) {
        if (index == 0 || Math.abs(index) > count) {
            return TriangleSoup.NONE;
        }
        return (int) (index > 0 ? index - 1 : count + index);
    }

    private void useMaterial(String name) {
        if (numberByMaterial.size() > MAX_MATERIALS) {
            throw text.failure("more than " + MAX_MATERIALS + " materials");
        }
        material = numberByMaterial.computeIfAbsent(name, _ -> numberByMaterial.size());
    }

    /** Reads one file whose name may contain spaces, or several files. */
    private void readLibraries(String names) throws IOException {
        if (isFile(names)) {
            tryLibrary(names);
        } else {
            for (String name : names.split("\\s+", -1)) {
                tryLibrary(name);
            }
        }
    }

    private boolean isFile(String name) {
        try {
            return Files.isRegularFile(PathsBeside.of(file, name, MeshException::new));
        } catch (MeshException _) {
            return false;
        }
    }

    private void tryLibrary(String name) throws IOException {
        try {
            Path library = PathsBeside.of(file, name, MeshException::new);
            InputFile.check(library);
            readLibrary(library);
        } catch (ClosedByInterruptException canceled) {
            throw canceled;
        } catch (MeshException refused) {
            warnings.add("material library: " + refused.getMessage());
        } catch (IOException unreadable) {
            warnings.add("material library " + QuotedText.text(name) + ": " + SystemReason.of(unreadable));
        }
    }

    private void readLibrary(Path library) throws IOException {
        if (++libraries > MAX_LIBRARIES) {
            throw new IOException("more than " + MAX_LIBRARIES + " material libraries");
        }
        try (FileChannel channel = FileChannel.open(library, StandardOpenOption.READ)) {
            Bytes content = Bytes.of(library, channel);
            if (content.startsWith(GitLfs.START)) {
                throw new IOException(GitLfs.PROBLEM);
            }
            if (content.length() > MAX_LIBRARY_BYTES) {
                throw new IOException(content.length() + " bytes; at most " + MAX_LIBRARY_BYTES + " are read");
            }
            new MtlReader(library, content, layouts, warnings).read().forEach(defined::putIfAbsent);
        }
    }

    /** Colors behind the coordinates of vertices in OBJ files: three numbers from 0 to 1, or to 255. */
    private static final class ObjColors {
        private final FloatList colors = new FloatList();
        private double largest = 1;

        /**
         * Reads what is behind the coordinates of a vertex: nothing, a weight, or a color.
         *
         * @param vertices number of vertices so far, including this one
         */
        void read(TextCursor text, int vertices) throws IOException {
            if (text.atLineEnd()) {
                return;
            }
            double red = text.number();
            if (text.atLineEnd()) {
                return;
            }
            double green = text.number();
            double blue = text.atLineEnd() ? green : text.number();
            while (colors.size() < 3 * (vertices - 1)) {
                colors.add(Float.NaN);
            }
            for (double value : new double[] {red, green, blue}) {
                colors.add((float) value);
                largest = value > largest ? 255 : largest;
            }
        }

        /** Adds the colors of all vertices, if any has one; the others are white. */
        void addTo(TriangleSoup soup) {
            for (int vertex = 0; vertex < soup.vertices() && colors.size() > 0; vertex++) {
                boolean given = 3 * vertex < colors.size() && !Float.isNaN(colors.get(3 * vertex));
                if (given) {
                    soup.color(linear(3 * vertex), linear(3 * vertex + 1), linear(3 * vertex + 2), 1);
                } else {
                    soup.color(1, 1, 1, 1);
                }
            }
        }

        private double linear(int at) {
            return SrgbCurve.linear(colors.get(at) / largest);
        }
    }
}
