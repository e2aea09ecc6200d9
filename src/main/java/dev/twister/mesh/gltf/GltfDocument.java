package dev.twister.mesh.gltf;

import dev.twister.files.PrintableText;
import dev.twister.mesh.input.Bytes;
import java.io.IOException;
import java.nio.ByteOrder;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The JSON of a glTF or GLB file, and the location of a GLB's binary chunk.
 *
 * @param binaryStart first byte of the binary chunk
 * @param binaryLength length in bytes; 0 if there is none
 */
public record GltfDocument(GltfPlace root, long binaryStart, long binaryLength) {
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;
    private static final int JSON_CHUNK = 0x4e4f534a;
    private static final int BINARY_CHUNK = 0x004e4942;
    private static final long MAX_JSON_BYTES = 1 << 30;

    /** Each token takes many times its length in memory; a file with 100,000 nodes has about 2 million. */
    private static final int MAX_TOKENS = 5_000_000;

    private static final int MAX_DEPTH = 64;

    public static GltfDocument read(Bytes bytes) throws IOException {
        return isBinary(bytes) ? readBinary(bytes) : new GltfDocument(json(bytes, 0, bytes.length()), 0, 0);
    }

    public static boolean isBinary(Bytes bytes) throws IOException {
        return bytes.startsWith("glTF");
    }

    private static GltfDocument readBinary(Bytes bytes) throws IOException {
        bytes.require(0, HEADER_BYTES + CHUNK_HEADER_BYTES, "the header");
        int version = bytes.intAt(4, ByteOrder.LITTLE_ENDIAN);
        if (version != 2) {
            throw bytes.failure(4, "GLB of version " + Integer.toUnsignedString(version) + "; version 2 is read");
        }
        long length = unsignedAt(bytes, 8);
        bytes.require(0, length, "the middle of its " + length + " bytes");
        long jsonLength = unsignedAt(bytes, HEADER_BYTES);
        if (bytes.intAt(HEADER_BYTES + 4, ByteOrder.LITTLE_ENDIAN) != JSON_CHUNK) {
            throw bytes.failure(HEADER_BYTES + 4, "the first chunk is not JSON");
        }
        long jsonStart = HEADER_BYTES + CHUNK_HEADER_BYTES;
        bytes.require(jsonStart, jsonLength, "the JSON chunk");
        GltfPlace root = json(bytes, jsonStart, jsonLength);
        long next = jsonStart + jsonLength;
        while (next + CHUNK_HEADER_BYTES <= length) {
            long chunkLength = unsignedAt(bytes, next);
            bytes.require(next + CHUNK_HEADER_BYTES, chunkLength, "a chunk");
            if (bytes.intAt(next + 4, ByteOrder.LITTLE_ENDIAN) == BINARY_CHUNK) {
                return new GltfDocument(root, next + CHUNK_HEADER_BYTES, chunkLength);
            }
            next += CHUNK_HEADER_BYTES + chunkLength;
        }
        return new GltfDocument(root, 0, 0);
    }

    private static long unsignedAt(Bytes bytes, long position) throws IOException {
        return Integer.toUnsignedLong(bytes.intAt(position, ByteOrder.LITTLE_ENDIAN));
    }

    private static GltfPlace json(Bytes bytes, long start, long length) throws IOException {
        if (length > MAX_JSON_BYTES) {
            throw bytes.failure("JSON of " + length + " bytes; at most " + MAX_JSON_BYTES + " are read: use GLB");
        }
        StreamReadConstraints constraints = StreamReadConstraints.builder()
                .maxStringLength((int) MAX_JSON_BYTES)
                .maxTokenCount(MAX_TOKENS)
                .maxNestingDepth(MAX_DEPTH)
                .build();
        JsonMapper mapper = JsonMapper.builder(
                        JsonFactory.builder().streamReadConstraints(constraints).build())
                // Some programs pad the chunk with zero bytes.
                .disable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                .build();
        try {
            JsonNode root = mapper.readTree(bytes.copy(start, (int) length));
            if (!root.isObject()) {
                throw bytes.failure("the JSON holds no object; not glTF");
            }
            return GltfPlace.root(bytes.name(), root);
        } catch (JacksonException problem) {
            throw bytes.failure(place(problem) + "not valid JSON: " + firstLine(problem.getOriginalMessage()));
        }
    }

    private static String place(JacksonException problem) {
        TokenStreamLocation place = problem.getLocation();
        return place == null ? "" : "line " + place.getLineNr() + ", column " + place.getColumnNr() + ": ";
    }

    private static String firstLine(String message) {
        String line = message.lines().findFirst().orElse("");
        // The rest describes the parser's own source.
        int source = line.indexOf(" (start marker");
        return PrintableText.line(source < 0 ? line : line.substring(0, source));
    }
}
