package dev.twister.mesh.obj;

import dev.twister.mesh.MeshException;
import dev.twister.mesh.input.Bytes;
import dev.twister.mesh.input.OptionalValue;
import dev.twister.mesh.input.QuotedText;
import dev.twister.mesh.input.TextCursor;
import dev.twister.mesh.input.TextureFiles;
import dev.twister.mesh.input.Warnings;
import dev.twister.scene.Material;
import dev.twister.scene.Rgb;
import dev.twister.scene.material.ImageMap;
import dev.twister.scene.material.Maps;
import dev.twister.scene.material.Sampler;
import dev.twister.scene.material.Wrap;
import dev.twister.scene.property.SceneLimits;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;

/** Reads the materials of an MTL file. */
final class MtlReader {
    private static final int MAX_MATERIALS = 10_000;
    private static final String NUMBER = "[+-]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?";
    private static final Set<String> UNUSED =
            Set.of("Ka", "sharpness", "map_Ka", "map_Ks", "map_Ns", "disp", "decal", "refl", "map_Ps");

    private final Path file;
    private final TextCursor text;
    private final MtlLayouts layouts;
    private final Warnings warnings;

    /** @param layouts receives the places of textures */
    MtlReader(Path file, Bytes bytes, MtlLayouts layouts, Warnings warnings) {
        this.file = file;
        this.text = new TextCursor(bytes);
        this.layouts = layouts;
        this.warnings = warnings;
    }

    Map<String, Material> read() throws IOException {
        Map<String, Material> materials = new HashMap<>();
        MtlMaterial current = new MtlMaterial();
        String name = "";
        while (!text.atEnd()) {
            if (!text.atLineEnd()) {
                String keyword = text.word();
                if (keyword.equals("newmtl")) {
                    materials.putIfAbsent(name, current.material());
                    current = new MtlMaterial();
                    name = text.rest();
                    if (materials.size() > MAX_MATERIALS) {
                        throw text.failure("more than " + MAX_MATERIALS + " materials");
                    }
                } else {
                    tryField(keyword, current);
                }
            }
            text.skipLine();
        }
        materials.putIfAbsent(name, current.material());
        return materials;
    }

    private void tryField(String keyword, MtlMaterial material) throws IOException {
        try {
            readField(keyword, material);
        } catch (MeshException problem) {
            warnings.add(problem, "; not read");
        }
    }

    private void readField(String keyword, MtlMaterial material) throws IOException {
        switch (keyword) {
            case "Kd" -> color().ifPresent(color -> material.diffuse = color);
            case "Ks" -> color().ifPresent(color -> material.specular = Optional.of(color));
            case "Tf" -> color().ifPresent(color -> material.filter = Optional.of(color));
            case "Ns" -> material.exponent = number();
            case "Ni" -> material.ior = Optional.of(number());
            case "d" -> {
                if (!text.atLineEnd() && text.atNumber()) {
                    material.opacity = Optional.of(number());
                }
            }
            case "Tr" -> material.transparency = Optional.of(number());
            case "illum" -> material.illumination = text.integer("an illumination model from 0 to 10");
            case "Ke" -> radiance().ifPresent(color -> material.emission = emission(color));
            case "Pr" -> material.roughness = Optional.of(number());
            case "Pm" -> material.metallic = Optional.of(number());
            case "Ps" -> material.sheen = unit();
            case "Pc" -> material.clearcoat = unit();
            case "Pcr" -> material.clearcoatRoughness = unit();
            case "aniso" -> material.anisotropy = unit();
            case "anisor" -> material.turn = number();
            case "map_Kd" -> material.texture = texture(text.rest());
            case "map_Ke" -> material.maps = mapped(material.maps, Maps::withEmission);
            case "map_d" -> material.maps = mapped(material.maps, Maps::withAlpha);
            case "map_Bump", "map_bump", "bump", "norm" -> material.maps = mapped(material.maps, Maps::withNormal);
            case "map_Pr" -> material.maps = mapped(material.maps, Maps::withRoughness);
            case "map_Pm" -> material.maps = mapped(material.maps, Maps::withMetallic);
            default -> {
                if (!UNUSED.contains(keyword)) {
                    warnings.add("material library: " + QuotedText.text(keyword) + " is not read");
                }
            }
        }
    }

    private Maps mapped(Maps maps, BiFunction<Maps, ImageMap, Maps> wither) throws IOException {
        return OptionalValue.with(maps, texture(text.rest()), wither);
    }

    private Optional<Rgb> color() throws IOException {
        return radiance()
                .map(color -> new Rgb(Math.min(color.red(), 1), Math.min(color.green(), 1), Math.min(color.blue(), 1)));
    }

    /** Three numbers or a single gray value; empty for a spectrum or CIE XYZ, which are rare. */
    private Optional<Rgb> radiance() throws IOException {
        if (!text.atLineEnd() && !text.atNumber()) {
            warnings.add("material library: a color as spectrum or CIE XYZ is not read");
            return Optional.empty();
        }
        double red = positive();
        if (text.atLineEnd()) {
            return Optional.of(new Rgb(red, red, red));
        }
        double green = positive();
        return Optional.of(new Rgb(red, green, text.atLineEnd() ? green : positive()));
    }

    private Rgb emission(Rgb color) {
        double most = SceneLimits.RADIANCE.max();
        if (Math.max(color.red(), Math.max(color.green(), color.blue())) > most) {
            warnings.add("material library: a Ke is limited to " + most);
        }
        return new Rgb(Math.min(color.red(), most), Math.min(color.green(), most), Math.min(color.blue(), most));
    }

    private double positive() throws IOException {
        return Math.max(number(), 0);
    }

    private double unit() throws IOException {
        return Math.min(positive(), 1);
    }

    private double number() throws IOException {
        double value = text.number();
        if (!Double.isFinite(value)) {
            throw text.failure("a number that is not finite");
        }
        return value;
    }

    /** The file name after the options of a texture. */
    private Optional<ImageMap> texture(String line) throws IOException {
        String rest = line;
        double factor = 1;
        double[] scale = {1, 1};
        double[] offset = {0, 0};
        Wrap wrap = Wrap.REPEAT;
        while (rest.matches("-[a-z].*")) {
            String next = withoutOption(rest);
            String option = rest.substring(0, rest.length() - next.length()).strip();
            if (option.matches("-bm\\s+" + NUMBER)) {
                factor = new BigDecimal(option.split("\\s+", 2)[1]).doubleValue();
            } else if (option.matches("-s(\\s+" + NUMBER + ")+")) {
                scale = twoNumbers(option, scale);
            } else if (option.matches("-o(\\s+" + NUMBER + ")+")) {
                offset = twoNumbers(option, offset);
            } else if (option.matches("-clamp\\s+on")) {
                wrap = Wrap.CLAMP;
            } else if (!option.matches("-clamp\\s+off")) {
                warnings.add("material library: the texture option " + QuotedText.text(option) + " is not read");
            }
            rest = next;
        }
        if (rest.isEmpty()) {
            return Optional.empty();
        }
        Sampler sampler = new Sampler(wrap, wrap, false, layouts.number(scale[0], scale[1], offset[0], offset[1]));
        double strength = factor;
        return TextureFiles.beside(file, rest, warnings).map(image -> new ImageMap(image, sampler, strength));
    }

    /** The first two of an option's numbers, of which the second is optional. */
    private static double[] twoNumbers(String option, double[] usual) {
        String[] words = option.split("\\s+", -1);
        return new double[] {
            new BigDecimal(words[1]).doubleValue(), words.length > 2 ? new BigDecimal(words[2]).doubleValue() : usual[1]
        };
    }

    private static String withoutOption(String line) {
        String[] option = line.split("\\s+", 2);
        String rest = option.length < 2 ? "" : option[1];
        int most = switch (option[0]) {
            case "-o", "-s", "-t" -> 3;
            case "-mm" -> 2;
            default -> 1;
        };
        for (int i = 0; i < most; i++) {
            String[] value = rest.split("\\s+", 2);
            // The last two of three numbers are optional.
            if (i > 0 && !value[0].matches(NUMBER)) {
                break;
            }
            rest = value.length < 2 ? "" : value[1];
        }
        return rest;
    }
}
