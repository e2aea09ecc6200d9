package dev.twister.cli.option;

import dev.twister.cli.file.BadInputException;
import dev.twister.render.FrameRange;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads {@code N}, how many, or {@code A-B}, the first and the last one. */
public final class FrameRangeConverter implements ITypeConverter<FrameRange> {
    private static final Pattern TEXT = Pattern.compile("(?<first>\\d{1,9})(?:-(?<last>\\d{1,9}))?");

    @Override
    public FrameRange convert(String text) {
        Matcher parts = TEXT.matcher(text);
        if (!parts.matches()) {
            throw new TypeConversionException(
                    "'" + text + "' is not a range of frames; write a number of frames, such as 600,"
                            + " or the first and the last one, such as 240-299");
        }
        int first = Integer.parseInt(parts.group("first"));
        if (parts.group("last") == null) {
            return FrameRange.ofCount(Ranges.check("--frames", first, 1, FrameRange.MOST));
        }
        int last = Integer.parseInt(parts.group("last"));
        if (last < first) {
            throw new BadInputException("--frames is " + text + ", but the last frame comes before the first one");
        }
        return FrameRange.of(first, Ranges.check("the last one of --frames", last, 0, FrameRange.MOST - 1));
    }
}
