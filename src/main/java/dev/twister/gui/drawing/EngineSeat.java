package dev.twister.gui.drawing;

import dev.twister.engine.Engine;
import dev.twister.engine.EngineException;
import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.engine.UnknownEngineException;
import dev.twister.image.Frame;
import dev.twister.world.FrameInput;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * The engine that draws, and the one that is to take its place. An engine is opened, and draws its first frame, which waits for
 * compilers, on a thread of its own, while the old one goes on drawing; it takes the seat when it is ready. Used by the drawing
 * thread alone.
 */
final class EngineSeat implements AutoCloseable {
    private final EngineOffer substitute;

    /** One after the other, however fast a person changes their mind. */
    private final ExecutorService openings = Executors.newSingleThreadExecutor(
            Thread.ofPlatform().daemon().name("opening an engine").factory());

    private Optional<Engine> seated = Optional.empty();
    private Optional<Candidate> candidate = Optional.empty();
    private long choice = Long.MIN_VALUE;
    private Optional<String> failure = Optional.empty();

    /** An engine on its way to the seat; one that is not wanted any more is not opened, or closed once it is open. */
    private record Candidate(EngineOffer offer, CompletableFuture<Engine> engine) {}

    /**
     * @param substitute draws until the first engine is ready, and when the seated one fails; must open at once
     */
    EngineSeat(EngineOffer substitute) {
        this.substitute = substitute;
    }

    /** The engine to draw this input with: the chosen one, where it is ready. */
    Engine engineFor(EngineChoice wanted, FrameInput input) {
        if (wanted.number() != choice) {
            choice = wanted.number();
            failure = Optional.empty();
            candidate.ifPresent(EngineSeat::dismiss);
            candidate = Optional.of(open(wanted.offer(), input));
        }
        candidate.filter(next -> next.engine().isDone() || mustWaitFor(next)).ifPresent(this::seat);
        return seated.orElseGet(() -> {
            Engine engine = substitute.opener().get();
            seated = Optional.of(engine);
            return engine;
        });
    }

    /** The id of the engine that is being opened. */
    Optional<String> opening() {
        return candidate.map(next -> next.offer().id());
    }

    /** Why the chosen engine does not draw. */
    Optional<String> failure() {
        return failure;
    }

    /** The seated engine failed while it drew: the substitute takes its place. */
    void giveUp(String why) {
        failure = Optional.of(why);
        seated.ifPresent(Engine::close);
        seated = Optional.empty();
    }

    @Override
    public void close() {
        candidate.ifPresent(EngineSeat::dismiss);
        candidate = Optional.empty();
        seated.ifPresent(Engine::close);
        seated = Optional.empty();
        openings.shutdown();
    }

    /** TornadoVM's runtime is one for all its engines: one does not compile while another draws. */
    private boolean mustWaitFor(Candidate next) {
        return isTornado(next.offer().id())
                && seated.filter(engine -> isTornado(engine.id())).isPresent();
    }

    private static boolean isTornado(String id) {
        return id.startsWith(Engines.TORNADO_PREFIX);
    }

    private void seat(Candidate next) {
        candidate = Optional.empty();
        try {
            Engine engine = next.engine().join();
            seated.ifPresent(Engine::close);
            seated = Optional.of(engine);
        } catch (CompletionException problem) {
            failure = Optional.of(explain(next.offer(), problem.getCause()));
        }
    }

    private static void dismiss(Candidate late) {
        CompletableFuture<Engine> engine = late.engine();
        if (!engine.cancel(false) && !engine.isCompletedExceptionally()) {
            engine.join().close();
        }
    }

    private Candidate open(EngineOffer offer, FrameInput input) {
        Candidate next = new Candidate(offer, new CompletableFuture<>());
        openings.execute(() -> {
            if (!next.engine().isDone()) {
                open(next, input);
            }
        });
        return next;
    }

    private static void open(Candidate next, FrameInput input) {
        try {
            Engine engine = warm(next.offer().opener().get(), input);
            if (!next.engine().complete(engine)) {
                engine.close();
            }
        } catch (RuntimeException | Error problem) {
            next.engine().completeExceptionally(problem);
        }
    }

    /** The first frame compiles what the engine needs compiled. */
    private static Engine warm(Engine engine, FrameInput input) {
        try {
            engine.render(input, Frame.ofPixels(input.width(), input.rows()));
            return engine;
        } catch (RuntimeException | Error problem) {
            engine.close();
            throw problem;
        }
    }

    static String explain(EngineOffer offer, Throwable problem) {
        return problem instanceof EngineException || problem instanceof UnknownEngineException
                ? problem.getMessage()
                : "engine " + offer.id() + " failed: " + problem;
    }
}
