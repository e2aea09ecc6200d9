package dev.twister.mesh;

import dev.twister.files.GitLfs;
import dev.twister.files.InputFile;
import dev.twister.files.SystemReason;
import dev.twister.mesh.gltf.GltfDocument;
import dev.twister.mesh.gltf.GltfReader;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.MeshLimits;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.Warnings;
import dev.twister.mesh.obj.ObjReader;
import dev.twister.mesh.ply.PlyReader;
import dev.twister.mesh.shape.ShapeMaker;
import dev.twister.mesh.shape.ShapeMaker.TrianglesOfCode;
import dev.twister.mesh.stl.StlReader;
import dev.twister.scene.Geometry;
import dev.twister.scene.Shape;
import dev.twister.scene.Triangles;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/** Reads mesh files: OBJ, glTF 2.0 (including binary), PLY and STL; makes shapes. */
public final class MeshReader {
    /** Endings of mesh files' names, in small letters. */
    public static final List<String> ENDINGS = List.of(".obj", ".gltf", ".glb", ".ply", ".stl");

    private MeshReader() {}

    /**
     * The triangles of a file, as {@link #read(Path, double, Consumer)}, of a shape, or of code.
     *
     * @param geometry a shape is a basis, see {@link Shape#basis}
     */
    public static MeshFile read(Geometry geometry, double smoothDegrees, Consumer<String> warnings) {
        return switch (geometry) {
            case Geometry.OfFile file -> read(file, smoothDegrees, warnings);
            case Shape basis -> ShapeMaker.file(basis);
            case Triangles triangles -> TrianglesOfCode.file(triangles, smoothDegrees);
        };
    }

    /**
     * Reads a mesh file of at most 2 GiB and 16,000,000 triangles. The format is detected by the first bytes or, if the
     * format has no signature, by the file's extension. The result uses Twister's axes: x right, y up, z into the
     * picture.
     *
     * @param file a file of the default file system
     * @param smoothDegrees for files without normals: the largest angle in [0, 180] between the planes of adjacent
     *     triangles that are shaded as one smooth surface; 0 for flat triangles
     * @param warnings receives one line, with the file's name, for each unsupported feature of the file
     * @throws MeshException if the file does not exist, is not in one of these formats, is damaged or too large
     */
    public static MeshFile read(Path file, double smoothDegrees, Consumer<String> warnings) {
        return read(new Geometry.OfFile(file), smoothDegrees, warnings);
    }

    private static MeshFile read(Geometry.OfFile source, double smoothDegrees, Consumer<String> warnings) {
        Path file = source.path();
        String name = QuotedText.path(file);
        try {
            InputFile.check(file);
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
                return read(source, Bytes.of(file, channel), smoothDegrees, new Warnings(name, warnings));
            }
        } catch (ClosedByInterruptException canceled) {
            throw new MeshException(name + ": reading was canceled", canceled);
        } catch (IOException problem) {
            throw new MeshException(name + ": " + SystemReason.of(problem), problem);
        }
    }

    /**
     * Whether the file's format has z up, as STL; the others have y up.
     *
     * @throws MeshException if the file cannot be read, or is in none of the formats
     */
    static boolean hasZUp(Path file) {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            return format(file, Bytes.of(file, channel)) == Format.STL;
        } catch (IOException problem) {
            throw new MeshException(QuotedText.path(file) + ": " + SystemReason.of(problem), problem);
        }
    }

    private static MeshFile read(Geometry.OfFile source, Bytes bytes, double smoothDegrees, Warnings warnings)
            throws IOException {
        Path file = source.path();
        if (bytes.length() == 0) {
            throw bytes.failure("an empty file");
        }
        if (bytes.length() > MeshLimits.FILE_BYTES) {
            throw bytes.failure(bytes.length() + " bytes; at most " + MeshLimits.FILE_BYTES + " (2 GiB) are read");
        }
        if (bytes.startsWith(GitLfs.START)) {
            throw bytes.failure(GitLfs.PROBLEM);
        }
        Format format = format(file, bytes);
        if (!source.scene().isEmpty() && format != Format.GLTF) {
            throw bytes.failure("has no scenes, but the scene " + QuotedText.text(source.scene())
                    + " is asked for; only glTF files have several");
        }
        MeshFile content = switch (format) {
            case GLTF -> new GltfReader(source, bytes, smoothDegrees, warnings).read();
            case OBJ -> new ObjReader(file, bytes, smoothDegrees, warnings).read();
            case PLY -> new PlyReader(file, bytes, smoothDegrees, warnings).read();
            case STL -> new StlReader(bytes, smoothDegrees, warnings).read();
        };
        if (content.degenerateTriangles() > 0) {
            warnings.add("triangles without area: " + content.degenerateTriangles() + "; not read");
        }
        return content;
    }

    private enum Format {
        GLTF,
        OBJ,
        PLY,
        STL
    }

    private static Format format(Path file, Bytes bytes) throws IOException {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (bytes.startsWith("ply\n") || bytes.startsWith("ply\r")) {
            return Format.PLY;
        }
        if (GltfDocument.isBinary(bytes) || name.endsWith(".gltf") || name.endsWith(".glb")) {
            return Format.GLTF;
        }
        if (name.endsWith(".stl") || StlReader.isBinary(bytes) || bytes.startsWith("solid")) {
            return Format.STL;
        }
        if (name.endsWith(".obj")) {
            return Format.OBJ;
        }
        throw bytes.failure("not a mesh by its first bytes or its name; OBJ, glTF, GLB, PLY and STL are read");
    }
}
