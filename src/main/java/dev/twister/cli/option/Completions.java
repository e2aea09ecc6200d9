package dev.twister.cli.option;

import dev.twister.bench.benchmark.Jit;
import dev.twister.cli.file.SceneFiles;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.scene.Integrator;
import dev.twister.scene.ToneMap;
import dev.twister.sky.ShippedSky;
import dev.twister.world.StageOrView;
import java.io.IOException;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;

/** What shells offer where options and scenes are typed: picocli makes one of each class. */
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

    static final class OfIntegrator implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return ChoiceConverter.names(Integrator.class).iterator();
        }
    }

    static final class OfToneMap implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return ChoiceConverter.names(ToneMap.class).iterator();
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

    public static final class OfJit implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return ChoiceConverter.names(Jit.class).iterator();
        }
    }

    public static final class OfPreset implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return ChoiceConverter.names(ShippedSky.class).iterator();
        }
    }
}
