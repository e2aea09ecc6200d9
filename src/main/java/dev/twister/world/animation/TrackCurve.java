package dev.twister.world.animation;

import dev.twister.scene.Easing;
import dev.twister.scene.Keyframe;
import dev.twister.scene.Track;
import java.util.List;
import java.util.stream.IntStream;

/** The value of a track at a time. */
public final class TrackCurve {
    private final List<Keyframe> keyframes;
    private final boolean loop;

    private TrackCurve(Track track) {
        keyframes = track.keyframes();
        loop = track.loop();
    }

    /** The numbers of the track's property, which the property's own range may still limit. */
    public static List<Double> at(Track track, double seconds) {
        return new TrackCurve(track).at(seconds);
    }

    private List<Double> at(double seconds) {
        double first = keyframes.getFirst().seconds();
        double length = keyframes.getLast().seconds() - first;
        if (length == 0 || (!loop && seconds <= first)) {
            return keyframes.getFirst().value();
        }
        double time = loop ? first + turned(seconds - first, length) : seconds;
        int index = 0;
        while (index < keyframes.size() - 1 && keyframes.get(index + 1).seconds() <= time) {
            index++;
        }
        return index == keyframes.size() - 1 ? keyframes.getLast().value() : between(index, time);
    }

    private static double turned(double seconds, double length) {
        return seconds - length * Math.floor(seconds / length);
    }

    private List<Double> between(int index, double time) {
        Keyframe from = keyframes.get(index);
        Keyframe to = keyframes.get(index + 1);
        double length = to.seconds() - from.seconds();
        double part = (time - from.seconds()) / length;
        return IntStream.range(0, from.value().size())
                .mapToObj(axis -> {
                    double start = from.value().get(axis);
                    double end = to.value().get(axis);
                    return switch (from.easing()) {
                        case HOLD -> start;
                        case LINEAR -> start + (end - start) * part;
                        case SMOOTH ->
                            hermite(start, end, part, length * slope(index, axis), length * slope(index + 1, axis));
                    };
                })
                .toList();
    }

    private static double hermite(double start, double end, double part, double startSlope, double endSlope) {
        double left = 1 - part;
        return left * left * (1 + 2 * part) * start
                + part * left * left * startSlope
                + part * part * (3 - 2 * part) * end
                - part * part * left * endSlope;
    }

    /**
     * The slope at a keyframe: the weighted harmonic mean of the slopes on its sides (Fritsch and Butland 1984), 0
     * where they have not the same sign, so that the curve is monotone between keyframes.
     */
    private double slope(int index, int axis) {
        int last = keyframes.size() - 1;
        boolean end = index == 0 || index == last;
        if (end && !loop) {
            return 0;
        }
        int before = end ? last - 1 : index - 1;
        int after = end ? 0 : index;
        double slopeBefore = side(before, axis);
        double slopeAfter = side(after, axis);
        if (slopeBefore * slopeAfter <= 0) {
            return 0;
        }
        double lengthBefore = length(before);
        double lengthAfter = length(after);
        double sum = lengthBefore + lengthAfter;
        return 3 * sum / ((sum + lengthAfter) / slopeBefore + (sum + lengthBefore) / slopeAfter);
    }

    /** The mean slope of a segment; 0 where the value is held. */
    private double side(int segment, int axis) {
        Keyframe from = keyframes.get(segment);
        double change =
                keyframes.get(segment + 1).value().get(axis) - from.value().get(axis);
        return from.easing() == Easing.HOLD ? 0 : change / length(segment);
    }

    private double length(int segment) {
        return keyframes.get(segment + 1).seconds() - keyframes.get(segment).seconds();
    }
}
