package dev.twister.mesh.ply;

import dev.twister.mesh.MeshFile;
import dev.twister.mesh.assembly.Axes;
import dev.twister.mesh.assembly.IntList;
import dev.twister.mesh.assembly.MeshAssembly;
import dev.twister.mesh.assembly.PolygonCutter;
import dev.twister.mesh.assembly.TriangleSoup;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.OptionalValue;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextCursor;
import dev.twister.mesh.input.TextureFiles;
import dev.twister.mesh.input.Warnings;
import dev.twister.mesh.ply.PlyHeader.Element;
import dev.twister.mesh.ply.PlyHeader.Property;
import dev.twister.scene.Material;
import dev.twister.scene.SrgbCurve;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** Reads PLY files: text, and binary in both byte orders. */
public final class PlyReader {
    private final Path file;
    private final Bytes bytes;
    private final double smoothDegrees;
    private final Warnings warnings;
    private final PolygonCutter cutter = new PolygonCutter();
    private final IntList polygon = new IntList();
    private final IntList strips = new IntList();

    public PlyReader(Path file, Bytes bytes, double smoothDegrees, Warnings warnings) {
        this.file = file;
        this.bytes = bytes;
        this.smoothDegrees = smoothDegrees;
        this.warnings = warnings;
    }

    public MeshFile read() throws IOException {
        TextCursor text = new TextCursor(bytes);
        PlyHeader header = PlyHeader.read(text, warnings);
        PlyValues values = header.order()
                .map(order -> PlyValues.binary(bytes, text.position(), order))
                .orElseGet(() -> PlyValues.text(text));
        TriangleSoup soup = new TriangleSoup(0, 0);
        for (Element element : header.elements()) {
            check(element, header.order().isPresent(), values);
            switch (element.name()) {
                case "vertex" -> readVertices(element, values, soup);
                case "face" -> readFaces(element, values, soup);
                case "tristrips" -> readStrips(element, values);
                default -> skip(element, values);
            }
        }
        addStrips(soup);
        soup.warnOfUnusable(warnings);
        Optional<Path> texture = header.texture().isPresent() && soup.textureCoordinates.size() > 0
                ? TextureFiles.beside(file, header.texture().get(), warnings)
                : Optional.empty();
        return MeshAssembly.assemble(soup, Axes.Y_UP, smoothDegrees)
                .file("", bytes, OptionalValue.with(Material.DEFAULT, texture, Material::withTexture));
    }

    private void check(Element element, boolean binary, PlyValues values) {
        long least = element.leastBytes(binary);
        // The last number of a text file needs no separator.
        if (least > 0 && element.count() > (values.remaining() + 1) / least) {
            throw bytes.failure("truncated: the header says " + element.count() + " of the element "
                    + QuotedText.text(element.name()) + ", but only " + values.remaining()
                    + " bytes are left for them; get or export it again");
        }
    }

    private void readVertices(Element element, PlyValues values, TriangleSoup soup) throws IOException {
        if (soup.vertices() > 0) {
            throw values.failure("the element 'vertex' is there twice");
        }
        if (element.count() > MeshLimits.VERTICES) {
            throw values.failure(element.count() + " vertices; at most " + MeshLimits.VERTICES + " are read");
        }
        int[] places = {element.indexOf("x"), element.indexOf("y"), element.indexOf("z")};
        int[] normals = {element.indexOf("nx"), element.indexOf("ny"), element.indexOf("nz")};
        int u = element.indexOf("u", "s", "texture_u", "texture_s");
        int v = element.indexOf("v", "t", "texture_v", "texture_t");
        for (int place : places) {
            if (place < 0) {
                throw bytes.failure("the element 'vertex' lacks x, y or z");
            }
        }
        boolean smooth = normals[0] >= 0 && normals[1] >= 0 && normals[2] >= 0;
        boolean textured = u >= 0 && v >= 0;
        Optional<PlyColor> color = PlyColor.of(element);
        double[] row = new double[element.properties().size()];
        for (long vertex = 0; vertex < element.count(); vertex++) {
            readRow(element, values, row);
            double x = row[places[0]];
            double y = row[places[1]];
            double z = row[places[2]];
            if (MeshLimits.areCoordinates(x, y, z)) {
                soup.position(x, y, z);
            } else {
                soup.missingPosition();
            }
            if (smooth) {
                soup.normal(row[normals[0]], row[normals[1]], row[normals[2]]);
            }
            if (textured) {
                soup.textureCoordinates(row[u], 1 - row[v]);
            }
            color.ifPresent(paint -> paint.add(row, soup));
        }
    }

    private void readRow(Element element, PlyValues values, double[] row) throws IOException {
        for (int i = 0; i < row.length; i++) {
            Property property = element.properties().get(i);
            if (property.count().isPresent()) {
                values.skip(property.type(), count(property, values));
                row[i] = 0;
            } else {
                row[i] = values.next(property.type());
            }
        }
        values.endElement();
    }

    private void readFaces(Element element, PlyValues values, TriangleSoup soup) throws IOException {
        int corners = cornersOf(element, values);
        if (element.count() > MeshLimits.TRIANGLES) {
            throw values.failure(MeshLimits.tooManyTriangles(element.count()));
        }
        if (element.indexOf("texcoord") >= 0) {
            warnings.add("faces have texture coordinates; those of vertices alone are read");
        }
        // Colors of vertices are finer than those of faces.
        Optional<PlyColor> color = soup.colors.size() > 0 ? Optional.empty() : PlyColor.of(element);
        double[] row = new double[element.properties().size()];
        for (long face = 0; face < element.count(); face++) {
            int first = soup.triangles();
            for (int i = 0; i < element.properties().size(); i++) {
                Property property = element.properties().get(i);
                if (i == corners) {
                    readPolygon(property, values, soup, face);
                } else if (property.count().isPresent()) {
                    values.skip(property.type(), count(property, values));
                } else {
                    row[i] = values.next(property.type());
                }
            }
            values.endElement();
            if (color.isPresent()) {
                color.get().add(row, soup);
                soup.paint(first);
            }
        }
    }

    private int cornersOf(Element element, PlyValues values) {
        int corners = element.indexOf("vertex_indices", "vertex_index");
        if (element.count() > 0
                && (corners < 0 || element.properties().get(corners).count().isEmpty())) {
            throw values.failure("the element " + QuotedText.text(element.name()) + " lacks its list vertex_indices");
        }
        return corners;
    }

    private void readPolygon(Property property, PlyValues values, TriangleSoup soup, long face) throws IOException {
        long count = count(property, values);
        if (count > MeshLimits.POLYGON_CORNERS) {
            throw values.failure("face " + face + " has " + count + " corners; at most " + MeshLimits.POLYGON_CORNERS
                    + " are read: triangulate it");
        }
        polygon.cut(0);
        for (long i = 0; i < count; i++) {
            double index = values.next(property.type());
            if (!(index >= 0 && index < soup.vertices()) || index != (int) index) {
                throw values.failure("face " + face + " has a vertex " + number(index) + "; "
                        + (soup.vertices() == 0
                                ? "there are none before it"
                                : "they are 0 to " + (soup.vertices() - 1)));
            }
            polygon.add((int) index);
        }
        if (count < 3) {
            warnings.add("there are faces of fewer than 3 corners; not read");
            return;
        }
        IntList cut = cutter.cut(soup.positions, polygon, (int) count);
        if (cutter.isExhausted()) {
            throw values.failure(PolygonCutter.EXHAUSTED);
        }
        for (int i = 0; i < cut.size(); i += 3) {
            soup.triangle(polygon.get(cut.get(i)), polygon.get(cut.get(i + 1)), polygon.get(cut.get(i + 2)));
        }
        checkTriangles(values, soup);
    }

    private static void checkTriangles(PlyValues values, TriangleSoup soup) {
        if (soup.triangles() > MeshLimits.TRIANGLES) {
            throw values.failure(MeshLimits.tooManyTriangles(soup.triangles()));
        }
    }

    /** Reads triangle strips, which are separated by -1. */
    private void readStrips(Element element, PlyValues values) throws IOException {
        int corners = cornersOf(element, values);
        for (long i = 0; i < element.count(); i++) {
            for (int j = 0; j < element.properties().size(); j++) {
                Property property = element.properties().get(j);
                if (j != corners) {
                    values.skip(property.type(), property.count().isPresent() ? count(property, values) : 1);
                    continue;
                }
                long count = count(property, values);
                for (long k = 0; k < count; k++) {
                    strips.add((int) Math.clamp(values.next(property.type()), -1.0, Integer.MAX_VALUE));
                    if (strips.size() > MeshLimits.VERTICES) {
                        throw values.failure(MeshLimits.tooManyTriangles(strips.size()));
                    }
                }
                strips.add(-1);
            }
            values.endElement();
        }
    }

    private void addStrips(TriangleSoup soup) {
        int length = 0;
        for (int i = 0; i < strips.size(); i++) {
            int corner = strips.get(i);
            if (corner >= soup.vertices()) {
                throw bytes.failure("a strip has a vertex " + corner + "; there are " + soup.vertices());
            }
            length = corner < 0 ? 0 : length + 1;
            if (length >= 3) {
                boolean even = length % 2 == 0;
                soup.triangle(strips.get(even ? i - 1 : i - 2), strips.get(even ? i - 2 : i - 1), corner);
            }
        }
        if (soup.triangles() > MeshLimits.TRIANGLES) {
            throw bytes.failure(MeshLimits.tooManyTriangles(soup.triangles()));
        }
    }

    private void skip(Element element, PlyValues values) throws IOException {
        if (element.properties().isEmpty()) {
            return;
        }
        double[] row = new double[element.properties().size()];
        for (long i = 0; i < element.count(); i++) {
            readRow(element, values, row);
        }
    }

    private static long count(Property property, PlyValues values) throws IOException {
        double count = values.next(property.count().orElseThrow());
        if (!(count >= 0 && count <= values.remaining()) || count != (long) count) {
            throw values.failure("a list " + QuotedText.text(property.name()) + " of " + number(count)
                    + " numbers, with " + values.remaining() + " bytes left");
        }
        return (long) count;
    }

    private static String number(double value) {
        return value == (long) value ? Long.toString((long) value) : Double.toString(value);
    }

    /**
     * The color in each row of an element of a PLY file.
     *
     * @param red number of the property in a row
     * @param largest what stands for 1
     */
    private record PlyColor(int red, int green, int blue, double largest) {
        /** Empty if the element has no color. */
        static Optional<PlyColor> of(Element element) {
            int red = element.indexOf("red", "diffuse_red", "r");
            int green = element.indexOf("green", "diffuse_green", "g");
            int blue = element.indexOf("blue", "diffuse_blue", "b");
            if (red < 0 || green < 0 || blue < 0) {
                return Optional.empty();
            }
            double largest = switch (element.properties().get(red).type()) {
                case BYTE, UNSIGNED_BYTE -> 255;
                case SHORT, UNSIGNED_SHORT -> 65_535;
                case INT, UNSIGNED_INT -> 255;
                case FLOAT, DOUBLE -> 1;
            };
            return Optional.of(new PlyColor(red, green, blue, largest));
        }

        void add(double[] row, TriangleSoup soup) {
            soup.color(linear(row[red]), linear(row[green]), linear(row[blue]), 1);
        }

        private double linear(double value) {
            return SrgbCurve.linear(value / largest);
        }
    }
}
