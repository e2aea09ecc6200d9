package dev.twister.mesh.gltf;

import dev.twister.files.GitLfs;
import dev.twister.files.InputFile;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.PathsBeside;
import dev.twister.mesh.input.QuotedText;
import java.io.Closeable;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** The buffers of a glTF file: in the GLB, embedded in the JSON, or in separate files. */
final class GltfBuffers implements Closeable {
    private static final int MAX_BUFFERS = 1000;
    private static final String DATA = "data:";

    /** A range of bytes that has been checked to exist. */
    record Range(Bytes bytes, long start, long length) {}

    private final Path file;
    private final Bytes bytes;
    private final GltfDocument document;
    private final Map<Integer, Range> opened = new HashMap<>();
    private final Map<String, Range> decompressed = new HashMap<>();
    private final List<FileChannel> channels = new ArrayList<>();

    GltfBuffers(Path file, Bytes bytes, GltfDocument document) {
        this.file = file;
        this.bytes = bytes;
        this.document = document;
    }

    /** The bytes of a buffer view, decompressed. */
    Range view(GltfPlace view) throws IOException {
        Optional<GltfPlace> compression = GltfMeshopt.of(view);
        if (compression.isEmpty()) {
            return stored(view);
        }
        Range known = decompressed.get("" + view);
        if (known == null) {
            Range compressed = stored(compression.get());
            byte[] all = GltfMeshopt.decode(
                    compression.get(),
                    compressed.bytes().copy(compressed.start(), Math.toIntExact(compressed.length())));
            known = new Range(Bytes.of(bytes.name() + ": " + view, all), 0, all.length);
            decompressed.put("" + view, known);
        }
        return known;
    }

    private Range stored(GltfPlace view) throws IOException {
        GltfPlace buffers = document.root().at("buffers");
        if (buffers.size() > MAX_BUFFERS) {
            throw buffers.failure("has " + buffers.size() + " items; at most " + MAX_BUFFERS + " are read");
        }
        int index = view.at("buffer").index(buffers);
        Range buffer = opened.get(index);
        if (buffer == null) {
            buffer = open(buffers.at(index), index);
            opened.put(index, buffer);
        }
        long offset = view.at("byteOffset").countOr(0);
        long length = view.at("byteLength").count();
        if (offset > buffer.length() || length > buffer.length() - offset) {
            throw view.failure("reaches to byte " + (offset + length) + " of a buffer of " + buffer.length());
        }
        return new Range(buffer.bytes(), buffer.start() + offset, length);
    }

    private Range open(GltfPlace buffer, int index) throws IOException {
        long length = buffer.at("byteLength").count();
        Range all = content(buffer, index);
        if (length > all.length()) {
            throw buffer.failure("is said to have " + length + " bytes, but has " + all.length() + "; truncated?");
        }
        return new Range(all.bytes(), all.start(), length);
    }

    private Range content(GltfPlace buffer, int index) throws IOException {
        GltfPlace uri = buffer.at("uri");
        if (!uri.exists()) {
            if (index != 0 || document.binaryLength() == 0) {
                throw buffer.failure("has no uri, and no bytes in this file");
            }
            return new Range(bytes, document.binaryStart(), document.binaryLength());
        }
        if (isData(uri)) {
            byte[] data = data(uri);
            return new Range(Bytes.of(bytes.name() + ": " + uri, data), 0, data.length);
        }
        Path path = PathsBeside.of(file, name(uri), problem -> uri.failure(": " + problem));
        Optional<String> problem = InputFile.problem(path);
        if (problem.isPresent()) {
            throw uri.failure("names a file beside this one, " + QuotedText.text(uri.text()) + ": " + problem.get());
        }
        FileChannel channel = FileChannel.open(path, StandardOpenOption.READ);
        channels.add(channel);
        Bytes content = Bytes.of(path, channel);
        if (content.startsWith(GitLfs.START)) {
            throw content.failure(GitLfs.PROBLEM);
        }
        return new Range(content, 0, content.length());
    }

    static boolean isData(GltfPlace uri) {
        return uri.text().regionMatches(true, 0, DATA, 0, DATA.length());
    }

    /** The bytes of a data URI. */
    static byte[] data(GltfPlace uri) {
        String text = uri.text();
        int comma = text.indexOf(',');
        if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
            throw uri.failure("is no data URI in base64");
        }
        try {
            return Base64.getDecoder().decode(text.substring(comma + 1));
        } catch (IllegalArgumentException broken) {
            throw uri.failure("is a broken data URI: no base64; export the file again");
        }
    }

    /** The file name in a relative URI. */
    static String name(GltfPlace uri) {
        String text = uri.text();
        try {
            // URLDecoder is meant for forms and would turn a plus into a space.
            return URLDecoder.decode(text.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException broken) {
            throw uri.failure("is " + QuotedText.text(text) + ", no valid URI");
        }
    }

    /** Total length in bytes of the opened buffers, and of what was decompressed. */
    long openedBytes() {
        return Stream.of(opened, decompressed)
                .flatMap(ranges -> ranges.values().stream())
                .mapToLong(Range::length)
                .sum();
    }

    @Override
    public void close() throws IOException {
        for (FileChannel channel : channels) {
            channel.close();
        }
    }
}
