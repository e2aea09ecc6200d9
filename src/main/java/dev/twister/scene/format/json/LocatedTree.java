package dev.twister.scene.format.json;

import dev.twister.scene.SceneException;
import dev.twister.scene.format.json.LocatedValue.ArrayValue;
import dev.twister.scene.format.json.LocatedValue.FlagValue;
import dev.twister.scene.format.json.LocatedValue.Member;
import dev.twister.scene.format.json.LocatedValue.NullValue;
import dev.twister.scene.format.json.LocatedValue.NumberValue;
import dev.twister.scene.format.json.LocatedValue.ObjectValue;
import dev.twister.scene.format.json.LocatedValue.TextValue;
import dev.twister.scene.property.SceneLimits;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamContext;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;

/**
 * Turns JSON text into {@link LocatedValue}s. The limits keep a hostile file from taking all memory; no scene comes
 * near them.
 */
public final class LocatedTree {
    /** The deepest value of a scene lies 4 levels down. */
    private static final int MAX_DEPTH = 16;

    /** No object of a scene has more fields than there may be materials. */
    private static final int MAX_FIELDS = SceneLimits.MAX_MATERIALS;

    /** No array of a scene has more items than there may be spheres. */
    private static final int MAX_ITEMS = SceneLimits.MAX_SPHERES;

    /** A sphere is 11 values; the largest file could hold 33 million. */
    private static final int MAX_VALUES = 8_000_000;

    /** A sphere is 3 of them: itself, its position and its color. Each costs many times its two characters. */
    private static final int MAX_CONTAINERS = 2_000_000;

    private static final int MAX_TOKEN_LENGTH = 100_000;

    private final SourceText source;
    private final JsonParser parser;
    private int values;
    private int containers;

    private LocatedTree(SourceText source, JsonParser parser) {
        this.source = source;
        this.parser = parser;
    }

    /**
     * Parses the whole text.
     *
     * @throws SceneException if the text is not one JSON object (RFC 8259), or goes beyond a limit
     */
    public static LocatedValue parse(SourceText source) {
        StreamReadConstraints constraints = StreamReadConstraints.builder()
                .maxStringLength(MAX_TOKEN_LENGTH)
                .maxNameLength(MAX_TOKEN_LENGTH)
                .build();
        JsonFactory factory = JsonFactory.builder()
                .streamReadConstraints(constraints)
                // Taken here only to be refused with its JSON path, as a number out of range.
                .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
                .build();
        try (JsonParser parser =
                factory.createParser(ObjectReadContext.empty(), source.characters(), 0, source.length())) {
            return new LocatedTree(source, parser).document();
        }
    }

    private LocatedValue document() {
        try {
            return wholeText();
        } catch (StreamConstraintsException e) {
            throw source.failure(reached(), "a number, a name or a string here is too long");
        } catch (JacksonException e) {
            throw source.failure(place(e), "not valid JSON: " + SyntaxMessage.of(e));
        }
    }

    private LocatedValue wholeText() {
        JsonToken first = parser.nextToken();
        if (first == null) {
            throw source.failure(source.length(), "the file holds only white space, but must hold a JSON object");
        }
        if (first != JsonToken.START_OBJECT) {
            throw source.failure(
                    offset(), "the file starts with " + source.excerpt(offset()) + ", but must hold a JSON object");
        }
        LocatedValue document = value(first, 0);
        // The parser stands on the closing brace. Whatever follows may be no JSON at all, so the parser is not asked.
        int rest = source.skipWhiteSpace(offset() + 1);
        if (rest < source.length()) {
            throw source.failure(rest, "the scene has ended, but " + source.excerpt(rest) + " follows");
        }
        return document;
    }

    private LocatedValue value(JsonToken token, int depth) {
        values++;
        if (values > MAX_VALUES) {
            throw source.failure(offset(), "a scene file may hold at most " + MAX_VALUES + " values");
        }
        int offset = offset();
        return switch (token) {
            case START_OBJECT -> object(offset, deeper(depth));
            case START_ARRAY -> array(offset, deeper(depth));
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new NumberValue(offset, parser.getDoubleValue());
            case VALUE_STRING -> new TextValue(offset, parser.getString());
            case VALUE_TRUE -> new FlagValue(offset, true);
            case VALUE_FALSE -> new FlagValue(offset, false);
            case VALUE_NULL -> new NullValue(offset);
            default -> throw source.failure(offset, "not valid JSON");
        };
    }

    private int deeper(int depth) {
        if (depth == MAX_DEPTH) {
            throw source.failure(offset(), "objects and arrays are nested more than " + MAX_DEPTH + " deep");
        }
        containers++;
        if (containers > MAX_CONTAINERS) {
            throw source.failure(offset(), "a scene file may hold at most " + MAX_CONTAINERS + " objects and arrays");
        }
        return depth + 1;
    }

    private ObjectValue object(int offset, int depth) {
        TokenStreamContext container = parser.streamReadContext();
        List<Member> members = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            String name = parser.currentName();
            int nameOffset = offset();
            for (Member earlier : members) {
                if (earlier.name().equals(name)) {
                    throw source.failure(
                            nameOffset,
                            path(container) + " is given twice, first on line " + source.line(earlier.offset()));
                }
            }
            if (members.size() == MAX_FIELDS) {
                throw source.failure(
                        nameOffset, path(container.getParent()) + " has more than " + MAX_FIELDS + " fields");
            }
            members.add(new Member(nameOffset, name, value(parser.nextToken(), depth)));
        }
        return new ObjectValue(offset, List.copyOf(members));
    }

    private ArrayValue array(int offset, int depth) {
        TokenStreamContext container = parser.streamReadContext();
        List<LocatedValue> items = new ArrayList<>();
        for (JsonToken token = parser.nextToken(); token != JsonToken.END_ARRAY; token = parser.nextToken()) {
            if (items.size() == MAX_ITEMS) {
                throw source.failure(offset(), path(container.getParent()) + " has more than " + MAX_ITEMS + " items");
            }
            items.add(value(token, depth));
        }
        return new ArrayValue(offset, List.copyOf(items));
    }

    /** Of what an object or array is at: paths are for messages alone, and millions of values have one. */
    private static JsonPath path(TokenStreamContext container) {
        if (container.inRoot()) {
            return new JsonPath.Root();
        }
        JsonPath parent = path(container.getParent());
        return container.inObject()
                ? new JsonPath.Field(parent, container.currentName())
                : new JsonPath.Item(parent, container.getCurrentIndex());
    }

    private int offset() {
        return (int) parser.currentTokenLocation().getCharOffset();
    }

    private long place(JacksonException failure) {
        return failure.getLocation() == null ? reached() : failure.getLocation().getCharOffset();
    }

    // How far the parser has come, which a broken limit does not say itself.
    private long reached() {
        return parser.currentLocation().getCharOffset();
    }

    /** The JSON parser's complaint in a person's words: without the parser's own settings and its copy of the place. */
    private static final class SyntaxMessage {
        private static final Pattern ANY_VALUE =
                Pattern.compile("(a valid value )?\\(JSON String, Number .*", Pattern.DOTALL);
        private static final Pattern HEXADECIMAL =
                Pattern.compile("hexadecimal number literals require enabling .*", Pattern.DOTALL);
        private static final Pattern PARSER_MATTERS = Pattern.compile(
                "(: enable `| \\(consider enabling | \\(start marker at | \\(for \\w+ starting at | \\(not recognized ).*",
                Pattern.DOTALL);

        private SyntaxMessage() {}

        static String of(JacksonException failure) {
            String message = String.valueOf(failure.getOriginalMessage());
            String plain = PARSER_MATTERS.matcher(message).replaceFirst("");
            String decimal = HEXADECIMAL.matcher(plain).replaceFirst("numbers must be decimal, not hexadecimal");
            return Excerpt.sentence(ANY_VALUE.matcher(decimal).replaceFirst("a value"));
        }
    }
}
