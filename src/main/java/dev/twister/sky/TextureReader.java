package dev.twister.sky;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;

/** Reads textures: PNG, JPEG and WebP pictures, told apart by their first bytes, whatever their names end in. */
public final class TextureReader {
    private TextureReader() {}

    /**
     * Reads a texture as {@link SkyboxReader#read(Path, Consumer)} reads panoramas, with the same limits, but keeps its
     * opacity apart. Radiance and OpenEXR pictures are refused: what a color is multiplied by is at most 1.
     *
     * @param file a file of the default file system
     * @param warnings told of what the file says and is not used; one line each that names the file
     * @return linear values in [0, 1], rows from the top
     * @throws SkyException where there is no such file, it is not a picture of these kinds, is damaged or too large
     */
    public static TextureImage read(Path file, Consumer<String> warnings) {
        return SkyboxReader.read(file, warnings, TextureReader::decode);
    }

    /**
     * The same from the bytes of a file.
     *
     * @param name what messages call it
     */
    public static TextureImage read(Path name, byte[] file, Consumer<String> warnings) {
        try {
            return decode(new FileBytes(file), warning -> warnings.accept(name + ": " + warning));
        } catch (IOException problem) {
            throw new SkyException(name + ": " + problem.getMessage(), problem);
        }
    }

    private static TextureImage decode(FileBytes file, Consumer<String> warnings) throws IOException {
        if (RadianceHeader.startsIn(file)) {
            throw new IOException("a Radiance picture, but a texture must be PNG, JPEG or WebP");
        }
        if (ExrPanorama.startsIn(file)) {
            throw new IOException("an OpenEXR picture, but a texture must be PNG, JPEG or WebP");
        }
        Optional<TextureImage> ordinary = SkyboxReader.decodeOrdinary(file, LinearImage::texture, warnings);
        if (ordinary.isEmpty()) {
            throw SkyboxReader.unknown(file, "texture", "PNG, JPEG and WebP");
        }
        return ordinary.get();
    }
}
