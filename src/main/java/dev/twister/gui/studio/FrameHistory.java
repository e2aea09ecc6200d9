package dev.twister.gui.studio;

import dev.twister.gui.drawing.DrawnPicture;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/** The frames of the last ten seconds: when they were finished and how long each step took. */
public final class FrameHistory {
    public static final double SECONDS = 10;

    private static final double NANOS_PER_SECOND = 1e9;
    private static final double NANOS_PER_MILLI = 1e6;
    private static final double RATE_SECONDS = 1;

    /** Without a picture for this time, and for several times the time of one, drawing has stopped. */
    private static final double REST_SECONDS = 2;

    private static final int PICTURES_MISSED = 3;

    private final Deque<Entry> entries = new ArrayDeque<>();

    /**
     * A picture that was shown.
     *
     * @param nanos when it was finished, by {@link System#nanoTime}
     * @param number counts every picture drawn, shown or not
     * @param renderMillis of the engine, without transfers
     * @param transferMillis to the device and back
     * @param displayMillis of JavaFX's thread in the pulse that showed the previous picture
     */
    public record Entry(long nanos, long number, double renderMillis, double transferMillis, double displayMillis) {}

    /** Adds a picture and removes those that are too old. */
    public void add(DrawnPicture picture, double displayMillis) {
        long transfer = picture.times().copyInNanos() + picture.times().copyOutNanos();
        entries.addLast(new Entry(
                picture.finishedNanos(),
                picture.number(),
                (picture.times().totalNanos() - transfer) / NANOS_PER_MILLI,
                transfer / NANOS_PER_MILLI,
                displayMillis));
        while (seconds(entries.getFirst(), entries.getLast()) > SECONDS && entries.size() > 2) {
            entries.removeFirst();
        }
    }

    /**
     * The entries of the last ten seconds, oldest first.
     *
     * @param nanos now, by {@link System#nanoTime}
     */
    public List<Entry> entries(long nanos) {
        return entries.stream()
                .filter(entry -> (nanos - entry.nanos()) / NANOS_PER_SECOND <= SECONDS)
                .toList();
    }

    /**
     * Pictures per second, over the last second or the last two pictures; 0 if there are fewer than two, or if drawing
     * has stopped.
     *
     * @param nanos now, by {@link System#nanoTime}
     */
    public double framesPerSecond(long nanos) {
        if (entries.size() < 2) {
            return 0;
        }
        Entry last = entries.getLast();
        Entry first = last;
        int counted = 0;
        for (Entry entry : (Iterable<Entry>) entries::descendingIterator) {
            if (counted >= 2 && seconds(entry, last) > RATE_SECONDS) {
                break;
            }
            first = entry;
            counted++;
        }
        double seconds = seconds(first, last);
        double ago = (nanos - last.nanos()) / NANOS_PER_SECOND;
        boolean rests = ago > REST_SECONDS && ago > PICTURES_MISSED * seconds / (counted - 1);
        return seconds > 0 && !rests ? (last.number() - first.number()) / seconds : 0;
    }

    /** The mean times of the last second, with the last picture's number. */
    public Entry mean() {
        Entry last = entries.isEmpty() ? new Entry(0, 0, 0, 0, 0) : entries.getLast();
        List<Entry> recent = entries.stream()
                .filter(entry -> seconds(entry, last) <= RATE_SECONDS)
                .toList();
        return new Entry(
                last.nanos(),
                last.number(),
                recent.stream().mapToDouble(Entry::renderMillis).average().orElse(0),
                recent.stream().mapToDouble(Entry::transferMillis).average().orElse(0),
                recent.stream().mapToDouble(Entry::displayMillis).average().orElse(0));
    }

    private static double seconds(Entry from, Entry to) {
        return (to.nanos() - from.nanos()) / NANOS_PER_SECOND;
    }
}
