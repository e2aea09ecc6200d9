package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.UnknownEngineException;
import dev.twister.engine.auto.FastestEngine;
import dev.twister.gui.drawing.DrawingRequest.EngineChoice;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * The engine that draws, and its successor. The successor is opened and draws its first frames, which wait for
 * compilers, on another thread while the old engine continues to render. Used only by the drawing thread.
 */
final class ActiveEngine implements AutoCloseable {
    private final EngineOffer substitute;
    private final Runnable whenReady;

    /** Opens one engine after the other, however fast the choice changes. */
    private final ExecutorService openings = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("opening an engine").factory());

    private Optional<Engine> current = Optional.empty();
    private Optional<Candidate> candidate = Optional.empty();
    private long choice = Long.MIN_VALUE;
    private boolean substituted = true;
    private Optional<String> failure = Optional.empty();
    private volatile boolean faster;

    /** An engine that is being opened. If it is no longer wanted, it is not opened, or closed once it is open. */
    private record Candidate(EngineOffer offer, CompletableFuture<Engine> engine) {}

    /**
     * @param substitute draws until the first engine is ready and when the present one fails; must open at once
     * @param whenReady called on another thread when opening has ended or the engine has switched to a faster one
     */
    ActiveEngine(EngineOffer substitute, Runnable whenReady) {
        this.substitute = substitute;
        this.whenReady = whenReady;
    }

    /**
     * Opens an engine if the choice is new; {@code warmUp} draws its first frames. Where the substitute draws and is
     * chosen, it stays.
     */
    void choose(EngineChoice wanted, WarmUp warmUp) {
        if (wanted.number() != choice) {
            choice = wanted.number();
            failure = Optional.empty();
            candidate.ifPresent(ActiveEngine::dismiss);
            boolean stays = substituted && wanted.offer().id().equals(substitute.id());
            candidate = stays ? Optional.empty() : Optional.of(open(wanted.offer(), warmUp));
        }
    }

    /** The engine to draw with now: the chosen one if it is ready. */
    Engine engine() {
        candidate.filter(next -> next.engine().isDone() || mustWaitFor(next)).ifPresent(this::use);
        return current.orElseGet(() -> {
            Engine engine = substitute.opener().get();
            current = Optional.of(engine);
            substituted = true;
            return engine;
        });
    }

    /** Whether the next frame will be drawn by another engine than the last. */
    boolean isReady() {
        return candidate.filter(next -> next.engine().isDone()).isPresent();
    }

    /** Whether the engine has switched to a faster one since the last call. */
    boolean hasBecomeFaster() {
        boolean has = faster;
        if (has) {
            faster = false;
        }
        return has;
    }

    /** Id of the engine that is being opened. */
    Optional<String> opening() {
        return candidate.map(next -> next.offer().id());
    }

    /** Why the chosen engine does not draw. */
    Optional<String> failure() {
        return failure;
    }

    /** Whether the substitute draws. */
    boolean isSubstituted() {
        return substituted;
    }

    /** Lets the engine rest, unless another one is being opened. */
    void rest() {
        if (candidate.isEmpty()) {
            current.ifPresent(Engine::rest);
        }
    }

    /** Replaces an engine that failed while drawing by the substitute. */
    void giveUp(Throwable problem) {
        failure = Optional.of(explain(current.map(Engine::id).orElse(substitute.id()), problem));
        closeCurrent();
    }

    @Override
    public void close() {
        candidate.ifPresent(ActiveEngine::dismiss);
        candidate = Optional.empty();
        closeCurrent();
        openings.shutdown();
    }

    private void closeCurrent() {
        current.ifPresent(Engine::close);
        current = Optional.empty();
    }

    /** TornadoVM has one runtime for all its engines: one must not compile while another draws. */
    private boolean mustWaitFor(Candidate next) {
        return Engines.isDevice(next.offer().id())
                && current.filter(engine -> Engines.isDevice(engine.id())).isPresent();
    }

    private void use(Candidate next) {
        candidate = Optional.empty();
        try {
            Engine engine = next.engine().join();
            closeCurrent();
            current = Optional.of(engine);
            substituted = false;
            engine.onFaster(() -> {
                faster = true;
                whenReady.run();
            });
        } catch (CompletionException problem) {
            failure = Optional.of(explain(next.offer().id(), problem.getCause()));
        }
    }

    private static void dismiss(Candidate late) {
        CompletableFuture<Engine> engine = late.engine();
        if (!engine.cancel(false) && !engine.isCompletedExceptionally()) {
            engine.join().close();
        }
    }

    private Candidate open(EngineOffer offer, WarmUp warmUp) {
        Candidate next = new Candidate(offer, new CompletableFuture<>());
        openings.execute(() -> {
            if (!next.engine().isDone()) {
                open(next, warmUp);
                whenReady.run();
            }
        });
        return next;
    }

    private static void open(Candidate next, WarmUp warmUp) {
        try {
            Engine engine = next.offer().opener().get();
            try {
                // It draws at once, and warms up its successor itself.
                if (!next.offer().id().equals(FastestEngine.AUTO)) {
                    warmUp.run(engine, next.engine()::isDone);
                }
            } catch (RuntimeException | Error problem) {
                engine.close();
                throw problem;
            }
            if (!next.engine().complete(engine)) {
                engine.close();
            }
        } catch (RuntimeException | Error problem) {
            next.engine().completeExceptionally(problem);
        }
    }

    private static String explain(String id, Throwable problem) {
        return switch (problem) {
            case EngineException _, UnknownEngineException _ -> problem.getMessage();
            case OutOfMemoryError _ ->
                "engine " + id + ": there is not enough memory for this picture; choose a smaller one";
            default -> "engine " + id + " failed: " + problem;
        };
    }
}
