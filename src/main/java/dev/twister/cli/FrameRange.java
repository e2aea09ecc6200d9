package dev.twister.cli;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * Frames of a film.
 *
 * @param first the number of the first one
 * @param last the number of the last one, at least the first's
 * @param counted whether only their number was given: then they are the whole film
 */
record FrameRange(int first, int last, boolean counted) {
    static final int MOST = 1_000_000;

    private static final Pattern TEXT = Pattern.compile("(?<first>\\d{1,9})(?:-(?<last>\\d{1,9}))?");

    /** As many frames, from 0 on. */
    static FrameRange ofCount(int count) {
        return new FrameRange(0, count - 1, true);
    }

    /** Both are in it. */
    static FrameRange of(int first, int last) {
        return new FrameRange(first, last, false);
    }

    int count() {
        return last - first + 1;
    }

    IntStream numbers() {
        return IntStream.rangeClosed(first, last);
    }

    /** Reads {@code N}, how many, or {@code A-B}, the first and the last one. */
    static final class Converter implements ITypeConverter<FrameRange> {
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
                return ofCount(Ranges.check("--frames", first, 1, MOST));
            }
            int last = Integer.parseInt(parts.group("last"));
            if (last < first) {
                throw new BadInputException("--frames is " + text + ", but the last frame comes before the first one");
            }
            return of(first, Ranges.check("the last one of --frames", last, 0, MOST - 1));
        }
    }
}
