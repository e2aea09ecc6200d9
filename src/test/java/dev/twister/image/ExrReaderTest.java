package dev.twister.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader.ExrExtent;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExrReaderTest {
    private static final Provenance MADE = new Provenance("Twister", "picture", "0-0");

    @TempDir
    private Path folder;

    @Test
    void readsWhichRowsAFileHas() throws IOException {
        Path file = file(new ExrPicture(3, 9, 2, 4, channels(12), Optional.of(MADE)));

        assertThat(ExrReader.extent(file)).isEqualTo(new ExrExtent(3, 9, 2, 4));
    }

    @Test
    void refusesMorePixelsThanItsBytesCanHold() throws IOException {
        Path file = file(new ExrPicture(3, 4, 0, 4, channels(12), Optional.empty()));
        byte[] bytes = Files.readAllBytes(file);
        setWindow(bytes, "dataWindow", 16_383);
        setWindow(bytes, "displayWindow", 16_383);
        Files.write(file, bytes);

        assertThatIOException()
                .isThrownBy(() -> ExrReader.extent(file))
                .withMessage(file + " is no .exr file, or is damaged");
    }

    @Test
    void aPartDoesNotAskForAPictureThatItsFilesCannotFill() throws IOException {
        ExrPicture part = new ExrPicture(3, Integer.MAX_VALUE, 0, 4, channels(12), Optional.of(MADE));
        Path file = file(part);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new JoinedPicture(file, part, List.of(ExrReader.extent(file))))
                .withMessage("the parts lack row 4 of 2147483647");
    }

    private Path file(ExrPicture picture) throws IOException {
        Path file = folder.resolve("part.exr");
        ExrWriter.write(file, picture);
        return file;
    }

    private static List<ExrChannel> channels(int pixels) {
        return List.of(new ExrChannel("R", new float[pixels], 0, 1));
    }

    /** Sets the last column and the last row. */
    private static void setWindow(byte[] bytes, String attribute, int last) {
        int at = new String(bytes, StandardCharsets.ISO_8859_1).indexOf(attribute + "\0box2i\0")
                + attribute.length()
                + "\0box2i\0".length()
                + 3 * Integer.BYTES;
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(at, last).putInt(at + Integer.BYTES, last);
    }
}
