package dev.twister.sky.image;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.twister.sky.PngBytes;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Collections;
import java.util.Iterator;
import javax.imageio.IIOException;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.metadata.IIOMetadata;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OrdinaryImageReaderTest {
    @TempDir
    Path folder;

    private final OutOfMemoryError memory = new OutOfMemoryError("Java heap space");

    @Test
    void tooLittleMemoryIsNoDamagedFile() throws IOException {
        Path file = Files.write(
                folder.resolve("sky.png"), PngBytes.start(1, 8, PngBytes.GRAY).texels(0));
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            EncodedImage image = new PngFile(new FileBytes(channel), warning -> {});
            assertThatThrownBy(() ->
                            OrdinaryImageReader.decode(new Failing(), OrdinaryImageFormat.PNG, image, image.meaning()))
                    .isSameAs(memory);
        }
    }

    /** Treats an error as a fault of the file, as ImageIO's own readers do. */
    private final class Failing extends ImageReader {
        Failing() {
            super(null);
        }

        @Override
        public int getNumImages(boolean allowSearch) {
            return 1;
        }

        @Override
        public int getWidth(int imageIndex) {
            return 4;
        }

        @Override
        public int getHeight(int imageIndex) {
            return 2;
        }

        @Override
        public Iterator<ImageTypeSpecifier> getImageTypes(int imageIndex) {
            return Collections.emptyIterator();
        }

        @Override
        public IIOMetadata getStreamMetadata() {
            throw new UnsupportedOperationException();
        }

        @Override
        public IIOMetadata getImageMetadata(int imageIndex) {
            throw new UnsupportedOperationException();
        }

        @Override
        public BufferedImage read(int imageIndex, ImageReadParam param) throws IOException {
            throw new IIOException("Error reading PNG image data", new IOException("Caught exception", memory));
        }
    }
}
