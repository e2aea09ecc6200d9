package dev.twister.image;

import dev.twister.files.InputFile;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads how a Radiance picture that {@link HdrWriter} wrote was made. */
final class HdrNotes {
    static final String VARIABLE = Provenance.NAME.toUpperCase(Locale.ROOT) + "=";

    static final String DISPLAY = DisplaySettings.NAME.toUpperCase(Locale.ROOT) + "=";

    private static final String SOFTWARE = Provenance.SOFTWARE.toUpperCase(Locale.ROOT) + "=";

    /** The resolution line of Twister's files. */
    private static final Pattern RESOLUTION = Pattern.compile("-Y (?<height>\\d{1,9}) \\+X (?<width>\\d{1,9})");

    private static final int LONGEST_LINE = 1024;
    private static final int LONGEST_LITERAL = 128;

    private HdrNotes() {}

    /**
     * The provenance in the header of a complete file.
     *
     * @throws IOException if the file is damaged or ends before its last row
     */
    static Optional<Provenance> of(Path file) throws IOException {
        try (InputStream bytes = InputFile.open(file);
                DataInputStream in = new DataInputStream(new BufferedInputStream(bytes))) {
            String software = "";
            Optional<String> text = Optional.empty();
            Optional<DisplaySettings> display = Optional.empty();
            String line = line(in);
            while (!line.isEmpty()) {
                if (line.startsWith(SOFTWARE)) {
                    software = line.substring(SOFTWARE.length());
                } else if (line.startsWith(VARIABLE)) {
                    text = Optional.of(line.substring(VARIABLE.length()));
                } else if (line.startsWith(DISPLAY)) {
                    display = DisplaySettings.of(line.substring(DISPLAY.length()));
                }
                line = line(in);
            }
            String made = software;
            Optional<DisplaySettings> shown = display;
            Optional<Provenance> provenance =
                    text.flatMap(found -> Provenance.of(made, found)).map(found -> found.withDisplay(shown));
            if (provenance.isPresent()) {
                skipRows(in, line(in));
            }
            return provenance;
        }
    }

    private static void skipRows(DataInputStream in, String resolution) throws IOException {
        Matcher sides = RESOLUTION.matcher(resolution);
        if (!sides.matches()) {
            throw new IOException("not the resolution line of a picture of Twister's");
        }
        int height = Integer.parseInt(sides.group("height"));
        int width = Integer.parseInt(sides.group("width"));
        for (int row = 0; row < height; row++) {
            if (RgbeRunLengths.fits(width)) {
                in.skipNBytes(4);
                for (int channel = 0; channel < 4; channel++) {
                    skipComponent(in, width);
                }
            } else {
                in.skipNBytes(4L * width);
            }
        }
    }

    private static void skipComponent(DataInputStream in, int width) throws IOException {
        int done = 0;
        while (done < width) {
            int count = in.readUnsignedByte();
            boolean isRun = count > LONGEST_LITERAL;
            in.skipNBytes(isRun ? 1 : count);
            done += isRun ? count - LONGEST_LITERAL : count;
        }
        if (done > width) {
            throw new IOException("a run that is longer than its row");
        }
    }

    private static String line(DataInputStream in) throws IOException {
        StringBuilder line = new StringBuilder();
        int next = in.readUnsignedByte();
        while (next != '\n' && line.length() < LONGEST_LINE) {
            line.append(new String(new byte[] {(byte) next}, StandardCharsets.ISO_8859_1));
            next = in.readUnsignedByte();
        }
        return line.toString();
    }
}
