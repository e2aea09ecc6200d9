package dev.twister.exr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import java.util.zip.DataFormatException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** Reads files of OpenEXR's own library and of OpenImageIO; their values are those that these read. */
class OpenExrFileTest {
    /** Made by .ci/image-corpus. */
    private static final List<String> FILES = List.of(
            "piz-float16",
            "piz-float32",
            "pxr24-float32",
            "pxr24-uint32",
            "b44-float16",
            "b44a-float16",
            "rle-float16",
            "zips-tiles-outside",
            "piz-rows-outside",
            "zip-parts",
            "levels");

    @ParameterizedTest
    @FieldSource("FILES")
    void hasTheValuesOfOtherPrograms(String name) throws IOException, DataFormatException {
        assertEqual(
                name,
                resource(name + ".exr"),
                new String(resource(name + ".txt"), StandardCharsets.UTF_8),
                resource(name + ".f32"));
    }

    private static void assertEqual(String name, byte[] exr, String text, byte[] expected)
            throws IOException, DataFormatException {
        List<String> words = List.of(text.strip().split(" "));
        OpenExrFile file = new OpenExrFile(bytes(exr));
        assertThat(file.width()).as(name).isEqualTo(Integer.parseInt(words.get(0)));
        assertThat(file.height()).as(name).isEqualTo(Integer.parseInt(words.get(1)));
        List<String> names = words.subList(2, words.size());
        assertThat(file.channels()).as(name).containsExactlyInAnyOrderElementsOf(names);
        FloatBuffer values =
                ByteBuffer.wrap(expected).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer();
        for (float[] channel : file.read(names)) {
            float[] whole = new float[file.width() * file.height()];
            System.arraycopy(channel, 0, whole, file.firstRow() * file.width(), channel.length);
            float[] wanted = new float[whole.length];
            values.get(wanted);
            assertThat(whole).as(name).isEqualTo(wanted);
        }
    }

    @Test
    void namesTheFirstOfSeveralParts() throws IOException, DataFormatException {
        OpenExrFile file = new OpenExrFile(bytes(resource("zip-parts.exr")));

        assertThat(file.firstPart()).contains("the first of 3 parts, 'part0'");
    }

    @Test
    void refusesOtherCompressionsByName() throws IOException {
        byte[] file = resource("b44-float16.exr");
        file[indexOf(file, "compression\0compression\0") + "compression\0compression\0".length() + 4] = 9;

        assertThatIOException()
                .isThrownBy(() -> new OpenExrFile(bytes(file)))
                .withMessageStartingWith("has DWAB compression, which is not read");
    }

    @Test
    void refusesFilesThatEndEarly() throws IOException {
        for (String name : FILES) {
            byte[] whole = resource(name + ".exr");
            // The smaller copies at the end are not read.
            byte[] file = Arrays.copyOf(whole, whole.length / 3);

            assertThatExceptionOfType(EOFException.class).as(name).isThrownBy(() -> readAll(bytes(file)));
        }
    }

    @Test
    void damagedFilesAreReadOrRefused() throws IOException {
        Random random = new Random(1);
        int mutations = Integer.getInteger("twister.mutations", 2000);
        for (int i = 0; i < mutations; i++) {
            byte[] file = resource(FILES.get(i % FILES.size()) + ".exr");
            for (int change = random.nextInt(8); change >= 0; change--) {
                int at = random.nextInt(file.length);
                file[at] = (byte) (random.nextBoolean() ? random.nextInt(256) : file[at] ^ 1 << random.nextInt(8));
            }
            try {
                readAll(bytes(file));
            } catch (IOException | DataFormatException refused) {
                assertThat(refused).isNotNull();
            }
        }
    }

    private static void readAll(ExrBytes bytes) throws IOException, DataFormatException {
        OpenExrFile file = new OpenExrFile(bytes);
        file.read(file.channels().stream().distinct().toList());
    }

    /** A folder of many files of all kinds. */
    @Tag("slow")
    @EnabledIfSystemProperty(named = "twister.images", matches = ".+")
    @Test
    void hasTheValuesOfOtherProgramsInManyFiles() throws IOException, DataFormatException {
        String folder = System.getProperty("twister.images");
        try (Stream<Path> files = Files.list(Path.of(folder))) {
            List<String> names = files.map(Path::toString)
                    .filter(file -> file.endsWith(".exr"))
                    .map(file -> file.replace(".exr", ""))
                    .toList();
            assertThat(names).hasSizeGreaterThanOrEqualTo(400);
            for (String name : names) {
                assertEqual(
                        name,
                        Files.readAllBytes(Path.of(name + ".exr")),
                        Files.readString(Path.of(name + ".txt")),
                        Files.readAllBytes(Path.of(name + ".f32")));
            }
        }
    }

    private static int indexOf(byte[] bytes, String text) {
        return new String(bytes, StandardCharsets.ISO_8859_1).indexOf(text);
    }

    private static ExrBytes bytes(byte[] file) {
        return new ExrBytes() {
            @Override
            public long length() {
                return file.length;
            }

            @Override
            public void copy(long position, byte[] target) {
                System.arraycopy(file, (int) position, target, 0, target.length);
            }
        };
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream file = OpenExrFileTest.class.getResourceAsStream("/exr/" + name)) {
            return file.readAllBytes();
        }
    }
}
