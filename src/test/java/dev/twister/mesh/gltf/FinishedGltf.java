package dev.twister.mesh.gltf;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Base64;
import javax.imageio.ImageIO;

/** A glTF file of one triangle, whose material has a finish. */
public final class FinishedGltf {
    static final String TEXTURE = "{\"index\":0}";

    /** All extensions, with # for {@link #TEXTURE}. */
    static final String ALL = """
        "KHR_materials_clearcoat":{"clearcoatFactor":0.1,"clearcoatRoughnessFactor":0.2,"clearcoatTexture":#,
          "clearcoatRoughnessTexture":#,"clearcoatNormalTexture":{"index":0,"scale":0.3}},
        "KHR_materials_sheen":{"sheenColorFactor":[0.1,0.2,0.3],"sheenRoughnessFactor":0.4,
          "sheenColorTexture":#,"sheenRoughnessTexture":#},
        "KHR_materials_anisotropy":{"anisotropyStrength":0.5,"anisotropyRotation":7,"anisotropyTexture":#},
        "KHR_materials_specular":{"specularFactor":0.6,"specularColorFactor":[0.7,0.8,900],
          "specularTexture":#,"specularColorTexture":#},
        "KHR_materials_iridescence":{"iridescenceFactor":0.11,"iridescenceIor":1.12,
          "iridescenceThicknessMinimum":130,"iridescenceThicknessMaximum":14000,"iridescenceTexture":#,
          "iridescenceThicknessTexture":#},
        "KHR_materials_dispersion":{"dispersion":0.15},
        "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.16,
          "diffuseTransmissionColorFactor":[0.17,0.18,0.19],"diffuseTransmissionTexture":#,
          "diffuseTransmissionColorTexture":#}
        """;

    private FinishedGltf() {}

    /** A file with all of them. */
    public static String example() {
        return of("\"extensions\":{" + ALL.replace("#", TEXTURE) + "}", 77);
    }

    /**
     * A triangle.
     *
     * @param material the fields of its material in JSON
     * @param alpha of the only texel of the image, or -1 if it has none
     */
    public static String of(String material, int alpha) {
        ByteBuffer corners = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
        for (float number : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1}) {
            corners.putFloat(number);
        }
        return """
                {"asset":{"version":"2.0"},"extensionsUsed":["KHR_materials_clearcoat","KHR_materials_sheen",
                "KHR_materials_anisotropy","KHR_materials_specular","KHR_materials_iridescence",
                "KHR_materials_dispersion","KHR_materials_diffuse_transmission"],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
                "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
                "buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,%s"}],
                "samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],
                "textures":[{"source":0},{"source":0,"sampler":0}],
                "images":[{"uri":"data:image/png;base64,%s"}],
                "materials":[{%s}]}
                """.formatted(text(corners.array()), text(png(alpha)), material);
    }

    private static byte[] png(int alpha) {
        BufferedImage image =
                new BufferedImage(1, 1, alpha < 0 ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, alpha << 24 | 0x102030);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", bytes);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return bytes.toByteArray();
    }

    private static String text(byte[] bytes) {
        return Base64.getEncoder().encodeToString(bytes);
    }
}
