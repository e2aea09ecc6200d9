package dev.twister.cli.option;

import dev.twister.cli.file.SceneFiles;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.world.StageOrView;
import java.io.IOException;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;

/** What shells offer beside {@link ChoiceConverter choices}: picocli makes one of each class. */
public final class Completions {
    private Completions() {}

    /** Engines that are known without a look for devices, and the names of families of devices. */
    public static final class OfEngine implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return Stream.concat(
                            Engines.offersAtOnce().stream().map(EngineOffer::id), Engines.deviceFamilies().stream())
                    .iterator();
        }
    }

    /** Shipped scenes; where nothing fits what is typed, a shell goes on with files. */
    public static final class OfScene implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            try {
                return SceneFiles.shipped().iterator();
            } catch (IOException _) {
                return Collections.emptyIterator();
            }
        }
    }

    /** Beside numbers. */
    static final class OfExposure implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return List.of(ExposureConverter.AUTO).iterator();
        }
    }

    static final class OfStage implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return StageOrView.stages().stream().map(StageOrView::stageId).iterator();
        }
    }

    static final class OfView implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return StageOrView.views().stream().map(StageOrView::id).iterator();
        }
    }
}
