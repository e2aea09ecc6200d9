package dev.twister.gui.drawing;

import dev.twister.sky.SkyException;
import dev.twister.sky.Skybox;
import dev.twister.sky.SkyboxReader;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.SequencedMap;
import java.util.StringJoiner;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * The panoramas used last, so that going back to one does not read its file again. Used by any thread; none waits while
 * another one reads a file.
 */
public final class SkyShelf {
    private static final int KEPT = 3;
    private static final long ASKED_EVERY_MILLIS = 20;

    private final BiFunction<Path, Consumer<String>, Skybox> reader;
    private final SequencedMap<Path, Skybox> skies = new LinkedHashMap<>();
    private final Map<Path, Long> editions = new HashMap<>();
    private volatile Optional<Path> beingRead = Optional.empty();
    private final Queue<String> warnings = new ConcurrentLinkedQueue<>();

    public SkyShelf() {
        this(SkyboxReader::read);
    }

    /** A shelf whose files are read by that. */
    SkyShelf(BiFunction<Path, Consumer<String>, Skybox> reader) {
        this.reader = reader;
    }

    /**
     * The panorama of that file, read where it is not at hand.
     *
     * @param wanted asked again and again meanwhile, whether it still is
     * @throws SkyException as {@link SkyboxReader#read} does, and where it is not wanted any more or was {@link #cancel
     *     canceled}
     */
    Skybox find(Path file, BooleanSupplier wanted) {
        return kept(file).orElseGet(() -> keep(file, await(file, wanted)));
    }

    /** What a thread waits for in {@link #find}. */
    public Optional<Path> beingRead() {
        return beingRead;
    }

    /** Whoever waits in {@link #find} waits no more. */
    public void cancel() {
        beingRead = Optional.empty();
    }

    private Skybox await(Path file, BooleanSupplier wanted) {
        CompletableFuture<Skybox> sky = new CompletableFuture<>();
        beingRead = Optional.of(file);
        Thread thread = Thread.ofPlatform().daemon().name("sky").start(() -> {
            try {
                sky.complete(reader.apply(file, warnings::add));
            } catch (RuntimeException | Error problem) {
                sky.completeExceptionally(problem);
            }
        });
        try {
            while (!sky.isDone()) {
                if (!wanted.getAsBoolean() || beingRead.isEmpty()) {
                    throw new SkyException(file + ": reading was canceled", new CancellationException());
                }
                waitFor(sky);
            }
            return sky.join();
        } catch (CompletionException problem) {
            throw thrown(problem.getCause());
        } finally {
            beingRead = Optional.empty();
            // Which closes the file under it.
            thread.interrupt();
        }
    }

    private static void waitFor(CompletableFuture<Skybox> sky) {
        try {
            sky.get(ASKED_EVERY_MILLIS, TimeUnit.MILLISECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException _) {
            // Whoever waits looks for itself.
        }
    }

    private static RuntimeException thrown(Throwable problem) {
        if (problem instanceof Error error) {
            throw error;
        }
        return (RuntimeException) problem;
    }

    /**
     * Reads a file anew, because it may have changed.
     *
     * @throws SkyException as {@link SkyboxReader#read} does; the panorama that was at hand stays then
     */
    public void refresh(Path file) {
        Skybox sky = reader.apply(file, warnings::add);
        synchronized (this) {
            keep(file, sky);
            editions.merge(file, 1L, Long::sum);
        }
    }

    /** What the files that were read since the last call say and is not used; empty where there is nothing. */
    public String takeWarnings() {
        StringJoiner taken = new StringJoiner("; ");
        for (String warning = warnings.poll(); warning != null; warning = warnings.poll()) {
            taken.add(warning);
        }
        return taken.toString();
    }

    /** How often a file was read anew: whoever has its panorama of another number has an old one. */
    synchronized long edition(Path file) {
        return editions.getOrDefault(file, 0L);
    }

    private synchronized Optional<Skybox> kept(Path file) {
        return Optional.ofNullable(skies.get(file)).map(sky -> keep(file, sky));
    }

    private synchronized Skybox keep(Path file, Skybox sky) {
        skies.remove(file);
        skies.putLast(file, sky);
        if (skies.size() > KEPT) {
            skies.pollFirstEntry();
        }
        return sky;
    }
}
