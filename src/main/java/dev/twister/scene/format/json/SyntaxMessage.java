package dev.twister.scene.format.json;

import java.util.regex.Pattern;
import tools.jackson.core.JacksonException;

/** The JSON parser's complaint in a person's words: without the parser's own settings and its copy of the place. */
final class SyntaxMessage {
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
