package dev.twister.render;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * File names of frames, which sort by frame number. The place of the number is {@code %04d} or {@code ####} in the
 * file's name; without one, {@code fall.png} becomes {@code fall-0000.png} and so on.
 */
public final class NumberedFiles {
    private static final int MIN_DIGITS = 4;
    private static final String ONE_PLACE = "must have one pattern for the frame number, such as %04d or ####";
    private static final Pattern PLACE = Pattern.compile("%(?:0(?<width>[1-9]))?d|#+");

    private final Path file;
    private final String start;
    private final int digits;
    private final String end;

    private NumberedFiles(Path file, String start, int digits, String end) {
        this.file = file;
        this.start = start;
        this.digits = digits;
        this.end = end;
    }

    /**
     * Whether a file's name has a place for the number. A single # is part of a name where no frames are asked for.
     */
    public static boolean hasPlace(Path file) {
        return PLACE.matcher(file.getFileName().toString())
                .results()
                .anyMatch(place -> !place.group().equals("#"));
    }

    /**
     * File names of a range of frames. A frame has the same name in every range of the film.
     *
     * @param file with an ending
     * @throws IllegalArgumentException if the name has two places for the number, or too few digits for the film's
     *     part; the message is the rest of a sentence that begins with the name
     */
    public static NumberedFiles of(Path file, FrameRange frames) {
        NumberedFiles files = of(file, frames.counted() ? frames.count() : 1);
        int needed = Integer.toString(frames.last()).length();
        if (!frames.counted() && files.digits > 1 && needed > files.digits) {
            throw new IllegalArgumentException("the number of frame " + frames.last() + " needs " + needed
                    + " digits; write " + "#".repeat(needed) + " or more in its place");
        }
        return files;
    }

    private static NumberedFiles of(Path file, int count) {
        String name = file.getFileName().toString();
        Matcher place = PLACE.matcher(name);
        if (!place.find()) {
            int ending = name.lastIndexOf('.');
            int digits = Math.max(MIN_DIGITS, Integer.toString(count - 1).length());
            return new NumberedFiles(file, name.substring(0, ending) + "-", digits, name.substring(ending));
        }
        NumberedFiles files =
                new NumberedFiles(file, name.substring(0, place.start()), digits(place), name.substring(place.end()));
        if (place.find()) {
            throw new IllegalArgumentException(ONE_PLACE);
        }
        return files;
    }

    private static int digits(Matcher place) {
        if (place.group().startsWith("#")) {
            return place.group().length();
        }
        return place.group("width") == null ? 1 : Integer.parseInt(place.group("width"));
    }

    /** The file of a frame; numbers with more digits than the place has make the name longer. */
    public Path file(int number) {
        return file.resolveSibling(start + String.format(Locale.ROOT, "%0" + digits + "d", number) + end);
    }

    /**
     * The existing files by frame number.
     *
     * @throws IOException if the folder does not exist or cannot be read
     */
    public SortedMap<Integer, Path> existing() throws IOException {
        Pattern name = Pattern.compile(Pattern.quote(start) + "(\\d{1,9})" + Pattern.quote(end));
        SortedMap<Integer, Path> files = new TreeMap<>();
        Path folder = Optional.ofNullable(file.getParent()).orElse(Path.of(""));
        if (!Files.isDirectory(folder)) {
            throw new IOException("there is no folder " + folder);
        }
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
            for (Path each : all) {
                Matcher number = name.matcher(each.getFileName().toString());
                if (number.matches()) {
                    Path expected = file(Integer.parseInt(number.group(1)));
                    if (expected.getFileName().equals(each.getFileName())) {
                        files.put(Integer.parseInt(number.group(1)), expected);
                    }
                }
            }
        }
        return files;
    }
}
