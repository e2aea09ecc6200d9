package dev.twister.scene.format;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The sample scene with one fault at a time, and the reader's message for each. */
final class SpoiltScenes {
    /**
     * One way to spoil the sample.
     *
     * @param sample the text to be spoiled
     * @param schemaSees whether the JSON Schema rejects it, too; it checks neither syntax, duplicates nor files
     * @param message the text after the file's name and a colon
     */
    record Spoilt(String sample, String name, boolean schemaSees, String part, String replacement, String message) {
        Spoilt(String name, boolean schemaSees, String part, String replacement, String message) {
            this(SampleScene.TEXT, name, schemaSees, part, replacement, message);
        }

        String text() {
            return SampleScene.with(sample, part, replacement);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    private static final SceneFormat FORMAT = new SceneFormat(1, new LinkedHashMap<>(), NamedFiles.UNRESOLVED);

    static final List<Spoilt> ALL = List.of(
            new Spoilt(
                    "not JSON",
                    false,
                    "{\n  \"$schema\"",
                    "hello\n  \"$schema\"",
                    "1:1: not valid JSON: Unrecognized token 'hello': was expecting a value"),
            new Spoilt(
                    "unquoted name",
                    false,
                    "\"yaw\": 0",
                    "yaw: 0",
                    "6:40: not valid JSON: Unexpected character ('y' (code 121)): was expecting double-quote to start property name"),
            new Spoilt(
                    "missing colon",
                    false,
                    "\"yaw\": 0",
                    "\"yaw\" 0",
                    "6:46: not valid JSON: Unexpected character ('0' (code 48)): was expecting a colon to separate property name and value"),
            new Spoilt(
                    "no value",
                    false,
                    "\"yaw\": 0",
                    "\"yaw\":",
                    "6:46: not valid JSON: Unexpected character (',' (code 44)): expected a value"),
            new Spoilt(
                    "trailing comma",
                    false,
                    "\"reflectivity\": 36}\n",
                    "\"reflectivity\": 36},\n",
                    "17:3: not valid JSON: Unexpected character (']' (code 93)): expected a value"),
            new Spoilt(
                    "comment",
                    false,
                    "  \"version\"",
                    "  // one\n  \"version\"",
                    "3:3: not valid JSON: Unexpected character ('/' (code 47)): maybe a (non-standard) comment?"),
            new Spoilt(
                    "leading zero",
                    false,
                    "\"pitch\": 7",
                    "\"pitch\": 07",
                    "6:60: not valid JSON: Invalid numeric value: Leading zeroes not allowed"),
            new Spoilt(
                    "line break in a string",
                    false,
                    "Every field",
                    "Every\nfield",
                    "5:24: not valid JSON: Illegal unquoted character ((CTRL-CHAR, code 10)): has to be escaped using backslash to be included in string value"),
            new Spoilt(
                    "wrong bracket",
                    false,
                    "[0, 1, 0]",
                    "[0, 1, 0}",
                    "16:62: not valid JSON: Unexpected close marker '}': expected ']'"),
            new Spoilt(
                    "cut off",
                    false,
                    "\"reflectivity\": 36}\n  ]\n}\n",
                    "\"reflectivity\": 36}\n",
                    "17:1: not valid JSON: Unexpected end-of-input: expected close marker for Array"),
            new Spoilt(
                    "control character in a word",
                    false,
                    "\"yaw\": 0",
                    "\"yaw\": \u202e0",
                    "6:47: not valid JSON: Unexpected character ('\\u202e' (code 8238 / 0x202e)): expected a value"),
            new Spoilt(
                    "trailing garbage",
                    false,
                    "  ]\n}\n",
                    "  ]\n}\n{\"version\": 1}",
                    "19:1: the scene has ended, but \"{\"version\": 1}\" follows"),
            new Spoilt(
                    "duplicate field",
                    false,
                    "\"yaw\": 0",
                    "\"yaw\": 0, \"yaw\": 1",
                    "6:50: $.camera.yaw is given twice, first on line 6"),
            new Spoilt(
                    "wrong version",
                    true,
                    "\"version\": 1",
                    "\"version\": 5",
                    "3:14: $.version is 5, but must be 1, 2, 3 or 4, the versions of the format that this program reads"),
            new Spoilt(
                    "version as text",
                    true,
                    "\"version\": 1",
                    "\"version\": \"1\"",
                    "3:14: $.version is \"1\", but must be 1, 2, 3 or 4, the versions of the format that this program reads"),
            new Spoilt(
                    "no version", true, "  \"version\": 1,\n", "", "1:1: $.version is missing; required here: version"),
            new Spoilt(
                    "unknown field",
                    true,
                    "\"radius\": 1.5, \"color\"",
                    "\"radius\": 1.5, \"colors\"",
                    "16:45: $.spheres[1] has an unknown field \"colors\" (did you mean \"color\"?); allowed here: position, radius, color, reflectivity"),
            new Spoilt(
                    "unknown field, nothing near",
                    true,
                    "\"yaw\": 0",
                    "\"yaw\": 0, \"zoom\": 2",
                    "6:50: $.camera has an unknown field \"zoom\"; allowed here: " + names(FORMAT.camera())),
            new Spoilt(
                    "unknown part",
                    true,
                    "\"shading\"",
                    "\"shader\"",
                    "10:3: $ has an unknown field \"shader\"; allowed here: " + names(FORMAT.scene())),
            new Spoilt(
                    "missing field",
                    true,
                    "\"radius\": 1.5, ",
                    "",
                    "16:5: $.spheres[1].radius is missing; required here: position, radius"),
            new Spoilt(
                    "missing part",
                    true,
                    ", \"seed\": 9",
                    "",
                    "13:11: $.pour.seed is missing; required here: count, rate, position, width, speed, radius, palette, seed"),
            new Spoilt(
                    "text for a number",
                    true,
                    "\"radius\": 1.5",
                    "\"radius\": \"1.5\"",
                    "16:40: $.spheres[1].radius is \"1.5\", but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "null",
                    true,
                    "\"radius\": 1.5",
                    "\"radius\": null",
                    "16:40: $.spheres[1].radius is null, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "array for a number",
                    true,
                    "\"radius\": 1.5",
                    "\"radius\": [1.5]",
                    "16:40: $.spheres[1].radius is an array of 1 item, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "object for an array",
                    true,
                    "[0, 1, 0]",
                    "{\"red\": 0}",
                    "16:54: $.spheres[1].color is an object, but must be an array of 3 numbers [red, green, blue]"),
            new Spoilt(
                    "two components",
                    true,
                    "[0, 1, 0]",
                    "[0, 1]",
                    "16:54: $.spheres[1].color is an array of 2 items, but must be an array of 3 numbers [red, green, blue]"),
            new Spoilt(
                    "four components",
                    true,
                    "[0, 1, 0]",
                    "[0, 1, 0, 1]",
                    "16:54: $.spheres[1].color is an array of 4 items, but must be an array of 3 numbers [red, green, blue]"),
            new Spoilt(
                    "NaN",
                    false,
                    "\"radius\": 1.5",
                    "\"radius\": NaN",
                    "16:40: $.spheres[1].radius is NaN, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "minus infinity",
                    false,
                    "\"radius\": 1.5",
                    "\"radius\": -Infinity",
                    "16:40: $.spheres[1].radius is -Infinity, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "more than a float",
                    true,
                    "\"radius\": 1.5",
                    "\"radius\": 1e300",
                    "16:40: $.spheres[1].radius is 1e300, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "more than a double",
                    false,
                    "\"radius\": 1.5",
                    "\"radius\": 1e999",
                    "16:40: $.spheres[1].radius is 1e999, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "negative radius",
                    true,
                    "\"radius\": 1.5",
                    "\"radius\": -1.5",
                    "16:40: $.spheres[1].radius is -1.5, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "zero radius",
                    true,
                    "\"radius\": 1.5",
                    "\"radius\": 0",
                    "16:40: $.spheres[1].radius is 0, but must be a number from 0.000001 to 1000000 meters"),
            new Spoilt(
                    "albedo above 1",
                    true,
                    "[0, 1, 0]",
                    "[0, 1.01, 0]",
                    "16:58: $.spheres[1].color[1] is 1.01, but must be a number from 0 to 1"),
            new Spoilt(
                    "negative light",
                    true,
                    "\"radius\": 1.2, \"color\": [1, 1, 1]",
                    "\"radius\": 1.2, \"color\": [1, 1, -1]",
                    "7:67: $.light.color[2] is -1, but must be a number from 0 to 1000000"),
            new Spoilt(
                    "far away",
                    true,
                    "[-4, -8, 0]",
                    "[-4, -8, 1000001]",
                    "15:27: $.spheres[0].position[2] is 1000001, but must be a number from -1000000 to 1000000 meters"),
            new Spoilt(
                    "pitch",
                    true,
                    "\"pitch\": 7",
                    "\"pitch\": 90.5",
                    "6:59: $.camera.pitch is 90.5, but must be a number from -90 to 90 degrees"),
            new Spoilt(
                    "field of view",
                    // A fisheye may have it.
                    false,
                    "\"fieldOfView\": 50",
                    "\"fieldOfView\": 180",
                    "6:77: $.camera.fieldOfView is 180, but must be a number from 1 to 179 degrees"),
            new Spoilt(
                    "reflectivity",
                    true,
                    "\"reflectivity\": 36",
                    "\"reflectivity\": 128.5",
                    "16:81: $.spheres[1].reflectivity is 128.5, but must be a number from 0 to 128"),
            new Spoilt(
                    "ambient",
                    true,
                    "\"ambient\": 0.25",
                    "\"ambient\": 1.5",
                    "10:26: $.shading.ambient is 1.5, but must be a number from 0 to 1"),
            new Spoilt(
                    "one plane color",
                    true,
                    "[[0.4, 0.4, 0.4], [0.2, 0.2, 0.2]]",
                    "[[0.4, 0.4, 0.4]]",
                    "8:52: $.plane.colors is an array of 1 item, but must be an array of 2 colors"),
            new Spoilt(
                    "fraction of a pixel",
                    true,
                    "\"width\": 640",
                    "\"width\": 640.5",
                    "11:26: $.rendering.width is 640.5, but must be a whole number from 1 to 16384 pixels"),
            new Spoilt(
                    "no pixels",
                    true,
                    "\"height\": 360",
                    "\"height\": 0",
                    "11:41: $.rendering.height is 0, but must be a whole number from 1 to 16384 pixels"),
            new Spoilt(
                    "too many samples",
                    true,
                    "\"samplesPerPixel\": 4",
                    "\"samplesPerPixel\": 65537",
                    "11:100: $.rendering.samplesPerPixel is 65537, but must be a whole number from 1 to 65536"),
            new Spoilt(
                    "too many bounces",
                    true,
                    "\"bounces\": 2",
                    "\"bounces\": 65",
                    "11:78: $.rendering.bounces is 65, but must be a whole number from 0 to 64"),
            new Spoilt(
                    "exposure",
                    true,
                    "\"exposure\": -0.5",
                    "\"exposure\": 21",
                    "11:115: $.rendering.exposure is 21, but must be a number from -20 to 20 stops"),
            new Spoilt(
                    "tone map",
                    true,
                    "\"aces\"",
                    "\"ACES\"",
                    "11:132: $.rendering.toneMap is \"ACES\", but must be one of \"clamp\", \"reinhard\", \"aces\""),
            new Spoilt(
                    "number for a flag",
                    true,
                    "\"srgb\": true",
                    "\"srgb\": 1",
                    "11:148: $.rendering.srgb is 1, but must be true or false"),
            new Spoilt(
                    "number for a name",
                    true,
                    "\"Sample\"",
                    "7",
                    "4:11: $.name is 7, but must be a string of 0 to 200 characters, none of them a control character"),
            new Spoilt(
                    "terminal codes in a name",
                    true,
                    "\"Sample\"",
                    "\"\\u001b[2J\\u0007\"",
                    "4:11: $.name is \"\\u001b[2J\\u0007\", but must be a string of 0 to 200 characters, none of them a control character"),
            new Spoilt(
                    "empty skybox",
                    true,
                    "\"sky.hdr\"",
                    "\"\"",
                    "9:13: $.skybox is \"\", but must be a string of 1 to 1000 characters, none of them a control character"),
            new Spoilt(
                    "skybox with NUL",
                    true,
                    "\"sky.hdr\"",
                    "\"\\u0000\"",
                    "9:13: $.skybox is \"\\u0000\", but must be a string of 1 to 1000 characters, none of them a control character"),
            new Spoilt(
                    "schema is a number",
                    true,
                    "\"scene.schema.json\"",
                    "3",
                    "2:14: $.$schema is 3, but must be a string of 0 to 1000 characters, none of them a control character"),
            new Spoilt(
                    "elasticity",
                    true,
                    "\"elasticity\": 0.75",
                    "\"elasticity\": 1.25",
                    "12:55: $.physics.elasticity is 1.25, but must be a number from 0 to 1"),
            new Spoilt(
                    "damping",
                    true,
                    "\"damping\": 0.05",
                    "\"damping\": -0.05",
                    "12:91: $.physics.damping is -0.05, but must be a number from 0 to 100 1/s"),
            new Spoilt(
                    "gravity",
                    true,
                    "[0, -1.62, 0]",
                    "[0, -1620, 0]",
                    "12:30: $.physics.gravity[1] is -1620, but must be a number from -1000 to 1000 m/s^2"),
            new Spoilt(
                    "walls",
                    true,
                    "\"walls\": false",
                    "\"walls\": \"no\"",
                    "12:106: $.physics.walls is \"no\", but must be true or false"),
            new Spoilt(
                    "palette",
                    true,
                    "\"lagoon\"",
                    "\"Lagoon\"",
                    "13:123: $.pour.palette is \"Lagoon\", but must be one of \"dusk\", \"lagoon\", \"orchard\""),
            new Spoilt(
                    "radii the wrong way round",
                    false,
                    "[0.2, 0.3]",
                    "[0.4, 0.3]",
                    "13:100: $.pour.radius is an array of 2 items, but must be an array of 2 numbers [least, most], the first not above the second"),
            new Spoilt(
                    "rate above what the spout gives",
                    false,
                    "\"rate\": 5.5",
                    "\"rate\": 90",
                    "13:33: $.pour.rate is 90, but must be at most 8.333 for spheres of that radius, speed and width of the spout"),
            new Spoilt(
                    "too many spheres together",
                    false,
                    "\"count\": 30",
                    "\"count\": 499999",
                    "13:21: $.pour.count is 499999, but must be at most 499998, which the 2 spheres of the scene leave of 500000"),
            new Spoilt(
                    "spheres is an object",
                    false,
                    "\"spheres\": [",
                    "\"spheres\": {\"a\": [",
                    "19:1: not valid JSON: Unexpected end-of-input: expected close marker for Object"),
            material(
                    "negative aperture",
                    true,
                    "\"aperture\": 0.125",
                    "\"aperture\": -0.125",
                    "3:93: $.camera.aperture is -0.125, but must be a number from 0 to 1000000 meters"),
            material(
                    "focus at the lens",
                    true,
                    "\"focusDistance\": 12.5",
                    "\"focusDistance\": 0",
                    "3:117: $.camera.focusDistance is 0, but must be a number from 0.000001 to 1000000 meters"),
            material(
                    "roughness",
                    true,
                    "\"roughness\": 0.125",
                    "\"roughness\": 1.5",
                    "14:98: $.spheres[1].roughness is 1.5, but must be a number from 0 to 1"),
            material(
                    "transmission",
                    true,
                    "\"transmission\": 0.5",
                    "\"transmission\": \"half\"",
                    "14:121: $.spheres[1].transmission is \"half\", but must be a number from 0 to 1"),
            material(
                    "index of refraction",
                    true,
                    "\"ior\": 1.25",
                    "\"ior\": 0.9",
                    "14:133: $.spheres[1].ior is 0.9, but must be a number from 1 to 4"),
            material(
                    "texture is no name",
                    true,
                    "\"ior\": 1.25, \"texture\": \"earth.png\"",
                    "\"ior\": 1.25, \"texture\": 7",
                    "14:150: $.spheres[1].texture is 7, but must be a string of 1 to 1000 characters, none of them a control character"),
            material(
                    "broken material",
                    true,
                    "\"ior\": 1.6",
                    "\"ior\": 4.5",
                    "6:83: $.materials.glass.ior is 4.5, but must be a number from 1 to 4"),
            material(
                    "unknown field of a material",
                    true,
                    "\"transmission\": 0.75",
                    "\"transparency\": 0.75",
                    "6:54: $.materials.glass has an unknown field \"transparency\"; allowed here: color, reflectivity, roughness, transmission, ior, texture"),
            material(
                    "material that is none",
                    true,
                    "\"glass\": {\"color\": [1, 1, 1], \"reflectivity\": 2, \"transmission\": 0.75, \"ior\": 1.6}",
                    "\"glass\": 3",
                    "6:14: $.materials.glass is 3, but must be an object"),
            material(
                    "material without a name",
                    true,
                    "\"glass\": {",
                    "\"\": {",
                    "6:5: $.materials has the name \"\", but a name must be a string of 1 to 200 characters, none of them a control character"),
            material(
                    "misspelt material",
                    false,
                    "\"material\": \"glass\"",
                    "\"material\": \"glas\"",
                    "13:59: $.spheres[0].material is \"glas\", but must be the name of one of the scene's materials (did you mean \"glass\"?): \"glass\", \"earth\""),
            material(
                    "unknown material",
                    false,
                    "\"material\": \"earth\"",
                    "\"material\": \"velvet\"",
                    "9:54: $.plane.material is \"velvet\", but must be the name of one of the scene's materials: \"glass\", \"earth\""),
            material(
                    "material by number",
                    true,
                    "\"material\": \"glass\"",
                    "\"material\": 1",
                    "13:59: $.spheres[0].material is 1, but must be the name of one of the scene's materials"),
            material(
                    "material and a field of its own",
                    true,
                    "\"material\": \"glass\"",
                    "\"material\": \"glass\", \"color\": [1, 1, 1]",
                    "13:77: $.spheres[0].color and \"material\" are both given; allowed beside \"material\": position, radius"),
            material(
                    "material and the plane's own colors",
                    true,
                    "\"oddColor\": [0.5, 0, 0]",
                    "\"colors\": [[1, 1, 1], [0, 0, 0]]",
                    "9:73: $.plane.colors and \"material\" are both given; allowed beside \"material\": size, height, oddColor"),
            material(
                    "second color without a material",
                    true,
                    "\"material\": \"earth\", ",
                    "\"colors\": [[1, 1, 1], [0, 0, 0]], \"reflectivity\": 1, ",
                    "9:107: $.plane.oddColor goes with \"material\" only, which is not given here; allowed without it: size, height, colors, reflectivity, roughness, transmission, ior, texture"),
            material(
                    "misspelt reference",
                    true,
                    "\"radius\": 1.5, \"color\"",
                    "\"radius\": 1.5, \"materal\": \"glass\", \"color\"",
                    "14:45: $.spheres[1] has an unknown field \"materal\" (did you mean \"material\"?); allowed here: position, radius, color, reflectivity, roughness, transmission, ior, texture, material"),
            first("lens", "\"fieldOfView\": 50", "\"fieldOfView\": 50, \"aperture\": 0.5", "6:93: $.camera.aperture"),
            first("materials", "  \"plane\"", "  \"materials\": {},\n  \"plane\"", "8:16: $.materials"),
            first(
                    "roughness",
                    "\"reflectivity\": 36",
                    "\"reflectivity\": 36, \"roughness\": 0.5",
                    "16:98: $.spheres[1].roughness"),
            first("material", "\"color\": [0, 1, 0]", "\"material\": \"a\"", "16:57: $.spheres[1].material"),
            first(
                    "texture of the plane",
                    "\"reflectivity\": 32",
                    "\"texture\": \"earth.png\", \"reflectivity\": 32",
                    "8:99: $.plane.texture"),
            shape(
                    "unknown shape",
                    true,
                    "\"box\"",
                    "\"cube\"",
                    "8:15: $.meshes[0].shape is \"cube\", but must be one of \"box\", \"quad\", \"cylinder\", \"cone\", \"torus\", \"icosphere\""),
            shape(
                    "size of two numbers",
                    true,
                    "[1, 2, 3]",
                    "[1, 2]",
                    "8:30: $.meshes[0].size is an array of 2 items, but must be a number or an array of 3 numbers [x, y, z]"),
            shape(
                    "size by a word",
                    true,
                    "[1, 2, 3]",
                    "\"large\"",
                    "8:30: $.meshes[0].size is \"large\", but must be a number or an array of 3 numbers [x, y, z]"),
            shape(
                    "no size",
                    true,
                    "[1, 2, 3]",
                    "0",
                    "8:30: $.meshes[0].size is 0, but must be a number from 0.000001 to 1000000 meters"),
            shape(
                    "flat box",
                    false,
                    "[1, 2, 3]",
                    "[1, 0, 3]",
                    "8:30: $.meshes[0].size is [1, 0, 3], but the size of a box must be numbers from 0.000001 to 1000000 meters"),
            shape(
                    "thick quad",
                    false,
                    "\"box\"",
                    "\"quad\"",
                    "8:31: $.meshes[0].size is [1, 2, 3], but the size of a quad must be [x, y, 0], with x and y from 0.000001 to 1000000 meters"),
            shape(
                    "ring without a hole",
                    false,
                    "\"box\"",
                    "\"torus\"",
                    "8:32: $.meshes[0].size is [1, 2, 3], but the size of a torus must be [x, y, z] from 0.000001 to 1000000 meters, with y below half of x"),
            shape(
                    "shape and file",
                    true,
                    "\"size\": [1",
                    "\"file\": \"earth.png\", \"size\": [1",
                    "8:30: $.meshes[0].file and \"shape\" are both given; allowed beside \"shape\": size, position, rotation, scale, material, name, group, hidden, locked, color, reflectivity, roughness, metallic, transmission, ior, emission, emissionStrength, doubleSided, lightGroup, attenuationColor, attenuationDistance, texture, emissionMap, roughnessMap, normalMap, alphaMode, alphaCutoff"),
            shape(
                    "size of a file",
                    true,
                    "\"shape\": \"box\"",
                    "\"file\": \"earth.png\"",
                    "8:35: $.meshes[0].size goes with \"shape\" only, which is not given here; allowed without it: file, scene, position, rotation, scale, smooth, material, name, group, hidden, locked, color, reflectivity, roughness, metallic, transmission, ior, emission, emissionStrength, doubleSided, lightGroup, attenuationColor, attenuationDistance, texture, emissionMap, roughnessMap, normalMap, alphaMode, alphaCutoff"),
            shape(
                    "neither file nor shape",
                    true,
                    "\"shape\": \"box\", \"size\": [1, 2, 3], ",
                    "",
                    "8:5: $.meshes[0].file is missing; required here: file"),
            shape(
                    "plane that emits",
                    false,
                    "\"reflectivity\": 32",
                    "\"reflectivity\": 32, \"emission\": [1, 1, 1]",
                    "5:116: $.plane.emission is given, but the plane cannot emit light; add a quad that does"),
            shape(
                    "plane of a material that emits",
                    false,
                    "\"plane\": {\"size\": 48, \"height\": 0, \"colors\": [[0.4, 0.4, 0.4], [0.2, 0.2, 0.2]], \"reflectivity\": 32}",
                    "\"materials\": {\"lamp\": {\"color\": [1, 1, 1], \"reflectivity\": 0, \"emission\": [1, 1, 1]}}, \"plane\": {\"size\": 48, \"height\": 0, \"material\": \"lamp\"}",
                    "5:137: $.plane.material is a material that emits, but the plane cannot emit light; add a quad that does"),
            shape(
                    "light without a radius",
                    true,
                    "\"radius\": 1.2",
                    "\"radius\": 0",
                    "4:46: $.light.radius is 0, but must be a number from 0.000001 to 1000000 meters"),
            shape(
                    "negative strength",
                    true,
                    "\"radius\": 1.2",
                    "\"radius\": 1.2, \"strength\": -1",
                    "4:63: $.light.strength is -1, but must be a number from 0 to 1000000000 m^2"),
            shape(
                    "infinite strength",
                    true,
                    "\"radius\": 1.2",
                    "\"radius\": 1.2, \"strength\": 1e999",
                    "4:63: $.light.strength is 1e999, but must be a number from 0 to 1000000000 m^2"),
            shape(
                    "shape in version 2",
                    true,
                    "\"version\": 3",
                    "\"version\": 2",
                    "8:15: $.meshes[0].shape needs \"version\": 3 at the top of the file"),
            first("poured glass", "\"reflectivity\": 12", "\"reflectivity\": 12, \"ior\": 2", "13:160: $.pour.ior"));

    private SpoiltScenes() {}

    private static Spoilt material(String name, boolean schemaSees, String part, String replacement, String message) {
        return new Spoilt(SampleScene.MATERIALS, name, schemaSees, part, replacement, message);
    }

    private static Spoilt shape(String name, boolean schemaSees, String part, String replacement, String message) {
        return new Spoilt(SampleScene.SHAPES, name, schemaSees, part, replacement, message);
    }

    /** Features of the second version in a file of the first. */
    private static Spoilt first(String name, String part, String replacement, String place) {
        return new Spoilt(
                name + " in version 1",
                true,
                part,
                replacement,
                place + " needs \"version\": 2 at the top of the file");
    }

    private static String names(ValueType.Structure<?> structure) {
        return Stream.concat(structure.names(true).stream(), structure.names(false).stream())
                .collect(Collectors.joining(", "));
    }
}
