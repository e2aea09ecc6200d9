package dev.twister.image;

import dev.twister.image.ExrPicture.ExrChannel;
import dev.twister.image.ExrReader.ExrExtent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Joins a picture from parts: tiles, which are ranges of rows, and ranges of samples, which are averaged. Rows of a
 * single part keep their bits. Messages of exceptions are one line.
 */
public final class JoinedPicture {
    /** The channel with the number of samples of each pixel, if pixels have different numbers. */
    public static final String SAMPLES = "samples.Y";

    private static final Pattern RANGE = Pattern.compile("(\\d{1,9})-(\\d{1,9})");

    private final int width;
    private final int height;
    private final String software;
    private final String picture;
    private final Optional<DisplaySettings> display;
    private final List<String> names;
    private final List<double[]> sums;
    private final List<List<Samples>> rows = new ArrayList<>();

    /** First and last sample; if a part states only their number, the first one is arbitrary. */
    private record Samples(int first, int last, String text, Path file) {
        int count() {
            return last - first + 1;
        }
    }

    /**
     * Creates a picture like a part, without its pixels.
     *
     * @param extents of all parts; without them, a file of a few bytes could ask for a picture of any size
     * @throws IllegalArgumentException if the part has no provenance, or rows are missing
     */
    public JoinedPicture(Path file, ExrPicture part, List<ExrExtent> extents) {
        Provenance made = provenance(file, part);
        if (extents.stream().mapToLong(ExrExtent::rows).sum() < part.height()) {
            throw lacksRow(ExrExtent.missingRow(extents), part.height());
        }
        width = part.width();
        height = part.height();
        software = made.software();
        picture = made.picture();
        display = made.display();
        names = part.channels().stream().map(ExrChannel::name).toList();
        sums = names.stream().map(_ -> new double[width * height]).toList();
        for (int row = 0; row < height; row++) {
            rows.add(new ArrayList<>());
        }
    }

    private static Provenance provenance(Path file, ExrPicture part) {
        return part.provenance()
                .orElseThrow(() -> new IllegalArgumentException(file
                        + " does not say how it was made; parts are written by 'twister render"
                        + " --tile' and '--sample-range'"));
    }

    /**
     * Adds a part.
     *
     * @throws IllegalArgumentException if it belongs to another picture, or repeats samples of another part
     */
    public void add(Path file, ExrPicture part) {
        Provenance made = provenance(file, part);
        List<String> channels = part.channels().stream().map(ExrChannel::name).toList();
        if (!made.picture().equals(picture)
                || part.width() != width
                || part.height() != height
                || !channels.equals(names)) {
            throw new IllegalArgumentException(
                    file + " is a part of another picture: its scene, settings, views or version of Twister differ");
        }
        Samples samples = samples(file, made.samples());
        for (int row = part.firstRow(); row < part.firstRow() + part.rows(); row++) {
            addTo(rows.get(row), samples, row);
        }
        checkSamples(file, part);
        int first = width * part.firstRow();
        int counted = names.indexOf(SAMPLES);
        for (int channel = 0; channel < sums.size(); channel++) {
            float[] values = part.channels().get(channel).values();
            double[] sum = sums.get(channel);
            for (int i = 0; i < values.length; i++) {
                double weight = counted < 0
                        ? samples.count()
                        : part.channels().get(counted).values()[i];
                sum[first + i] += channel == counted ? weight : weight * values[i];
            }
        }
    }

    /** A mean needs samples. */
    private void checkSamples(Path file, ExrPicture part) {
        int counted = names.indexOf(SAMPLES);
        if (counted >= 0) {
            for (float count : part.channels().get(counted).values()) {
                if (!(count > 0 && count <= Float.MAX_VALUE)) {
                    throw new IllegalArgumentException(file + " has a pixel of " + count + " samples in the layer "
                            + SAMPLES + "; expected 1 or more");
                }
            }
        }
    }

    private static Samples samples(Path file, String text) {
        Matcher range = RANGE.matcher(text);
        return range.matches()
                ? new Samples(Integer.parseInt(range.group(1)), Integer.parseInt(range.group(2)), text, file)
                : new Samples(0, 0, text, file);
    }

    private static void addTo(List<Samples> row, Samples samples, int number) {
        for (Samples other : row) {
            if (samples.first() <= other.last() && other.first() <= samples.last()) {
                throw new IllegalArgumentException(samples.file() + " and " + other.file() + " both have samples "
                        + samples.text() + " of row " + number + "; give each part once");
            }
        }
        row.add(samples);
    }

    /**
     * The picture.
     *
     * @throws IllegalArgumentException if rows or samples are missing
     */
    public ExrPicture whole() {
        List<String> wanted = texts(0);
        for (int row = 0; row < height; row++) {
            checkIsWhole(row, wanted);
        }
        List<ExrChannel> channels = new ArrayList<>();
        int counted = names.indexOf(SAMPLES);
        for (int channel = 0; channel < names.size(); channel++) {
            float[] values = counted < 0
                    ? mean(sums.get(channel))
                    : weighted(
                            sums.get(channel), channel == counted ? Optional.empty() : Optional.of(sums.get(counted)));
            channels.add(new ExrChannel(names.get(channel), values, 0, 1));
        }
        Provenance made = new Provenance(software, picture, samples(), display);
        return new ExrPicture(width, height, 0, height, channels, Optional.of(made));
    }

    private static IllegalArgumentException lacksRow(int row, int height) {
        return new IllegalArgumentException("the parts lack row " + row + " of " + height);
    }

    private void checkIsWhole(int row, List<String> wanted) {
        if (rows.get(row).isEmpty()) {
            throw lacksRow(row, height);
        }
        if (!texts(row).equals(wanted)) {
            throw new IllegalArgumentException("row " + row + " has samples " + String.join(", ", texts(row))
                    + ", but row 0 has samples " + String.join(", ", wanted) + "; a part is missing");
        }
    }

    private List<String> texts(int row) {
        return sorted(row).stream().map(Samples::text).toList();
    }

    private List<Samples> sorted(int row) {
        return rows.get(row).stream()
                .sorted(Comparator.comparingInt(Samples::first))
                .toList();
    }

    private String samples() {
        List<Samples> all = sorted(0);
        for (int index = 1; index < all.size(); index++) {
            int next = all.get(index - 1).last() + 1;
            if (all.get(index).first() != next) {
                throw new IllegalArgumentException(
                        "the parts lack samples " + next + "-" + (all.get(index).first() - 1));
            }
        }
        return all.size() == 1
                ? all.getFirst().text()
                : all.getFirst().first() + "-" + all.getLast().last();
    }

    /** The sums divided by the pixels' samples, or the sums of the samples themselves. */
    private static float[] weighted(double[] sum, Optional<double[]> samples) {
        float[] values = new float[sum.length];
        for (int i = 0; i < sum.length; i++) {
            values[i] = (float) (samples.isPresent() ? sum[i] / samples.get()[i] : sum[i]);
        }
        return values;
    }

    private float[] mean(double[] sum) {
        float[] mean = new float[sum.length];
        for (int row = 0; row < height; row++) {
            int count = rows.get(row).stream().mapToInt(Samples::count).sum();
            for (int i = width * row; i < width * (row + 1); i++) {
                mean[i] = (float) (sum[i] / count);
            }
        }
        return mean;
    }
}
