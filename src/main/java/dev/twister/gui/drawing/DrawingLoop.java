package dev.twister.gui.drawing;

import dev.twister.engine.EngineOffer;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/** Draws the newest request on a thread of its own. {@link #request} and {@link #takeNewest} return at once. */
public final class DrawingLoop implements AutoCloseable {
    /** The engine rests after this time without requests. */
    private static final long REST_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final PictureExchange exchange = new PictureExchange();
    private final ProgressiveRenderer work;
    private final Thread thread;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private Optional<DrawingRequest> newest = Optional.empty();
    private boolean due;
    private boolean closed;
    private final Deque<RadianceQuestion> questions = new ArrayDeque<>();
    private volatile Status status = Status.QUIET;

    private record RadianceQuestion(DrawnPicture picture, CompletableFuture<Optional<float[]>> answer) {}

    /**
     * A loop whose thread has not been started.
     *
     * @param skies reads panoramas
     * @param meshes reads meshes
     * @param substitute draws until the chosen engine is ready, and if it fails; must open at once
     */
    public DrawingLoop(ImageCache skies, MeshCache meshes, EngineOffer substitute) {
        this(skies, meshes, substitute, System::nanoTime);
    }

    /** For tests: a loop with another clock than {@link System#nanoTime}. */
    DrawingLoop(ImageCache skies, MeshCache meshes, EngineOffer substitute, LongSupplier clock) {
        work = new ProgressiveRenderer(exchange, skies, meshes, substitute, this::newest, this::wake, clock);
        thread = Thread.ofPlatform().daemon().name("drawing").unstarted(this::run);
    }

    /** Starts the thread, which waits for a request. */
    public void start() {
        thread.start();
    }

    /** Replaces the request; the next picture answers the new one. */
    public void request(DrawingRequest request) {
        lock.lock();
        try {
            newest = Optional.of(request);
            due = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** See {@link PictureExchange#takeNewest}. */
    public Optional<DrawnPicture> takeNewest() {
        return exchange.takeNewest();
    }

    /**
     * Also hands each whole picture to a watcher, on the drawing thread. The pixels are valid until the watcher
     * returns.
     */
    public void watch(Consumer<DrawnPicture> watcher) {
        work.watch(Optional.of(watcher));
    }

    /** Removes the watcher. */
    public void unwatch() {
        work.watch(Optional.empty());
    }

    /**
     * The linear samples that a refined picture has gathered so far, as {@link dev.twister.image.Frame#radiance} has
     * them. Empty if it was not refined or another picture is being drawn.
     */
    public CompletableFuture<Optional<float[]>> radiance(DrawnPicture picture) {
        CompletableFuture<Optional<float[]>> answer = new CompletableFuture<>();
        lock.lock();
        try {
            if (closed) {
                answer.complete(Optional.empty());
            } else {
                questions.add(new RadianceQuestion(picture, answer));
                changed.signalAll();
            }
        } finally {
            lock.unlock();
        }
        return answer;
    }

    public Status status() {
        return status;
    }

    /** Ends the thread after its present picture and closes its engine; does not wait for it. */
    @Override
    public void close() {
        lock.lock();
        try {
            closed = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /** Waits for the thread to end; returns whether it did. */
    public boolean awaitEnd(Duration limit) throws InterruptedException {
        return thread.join(limit);
    }

    private void run() {
        try (work) {
            boolean more = false;
            Optional<DrawingRequest> next = await(more);
            while (next.isPresent()) {
                answerQuestions();
                boolean drawable = work.prepare(next.get());
                status = work.status();
                more = drawable && work.step(next.get());
                status = work.status();
                if (drawable && !more && isQuiet()) {
                    work.rest();
                }
                next = await(more);
            }
        } finally {
            answerQuestions();
        }
    }

    private void answerQuestions() {
        Optional<RadianceQuestion> question = nextQuestion();
        while (question.isPresent()) {
            answer(question.get());
            question = nextQuestion();
        }
    }

    /** The caller waits, so every request gets an answer. */
    private void answer(RadianceQuestion question) {
        try {
            question.answer().complete(work.radiance(question.picture()));
        } catch (RuntimeException | Error problem) {
            question.answer().completeExceptionally(problem);
        }
    }

    private Optional<RadianceQuestion> nextQuestion() {
        lock.lock();
        try {
            return Optional.ofNullable(questions.poll());
        } finally {
            lock.unlock();
        }
    }

    /** Waits for a while; returns whether there is still nothing to do. */
    private boolean isQuiet() {
        lock.lock();
        try {
            long left = REST_NANOS;
            while (!closed && !due && questions.isEmpty() && left > 0) {
                left = changed.awaitNanos(left);
            }
            return left <= 0;
        } catch (InterruptedException _) {
            return false;
        } finally {
            lock.unlock();
        }
    }

    /** Waits until there is something to do, and returns the newest request; empty if the loop is closed. */
    private Optional<DrawingRequest> await(boolean more) {
        lock.lock();
        try {
            while (!closed && !due && !more && questions.isEmpty()) {
                changed.awaitUninterruptibly();
            }
            due = false;
            return closed ? Optional.empty() : newest;
        } finally {
            lock.unlock();
        }
    }

    /** The newest request; empty if the loop is closed. */
    private Optional<DrawingRequest> newest() {
        lock.lock();
        try {
            return closed ? Optional.empty() : newest;
        } finally {
            lock.unlock();
        }
    }

    /** Wakes the thread, for example when an engine has opened. */
    private void wake() {
        lock.lock();
        try {
            due = newest.isPresent();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /**
     * The state of the drawing thread.
     *
     * @param opening id of the engine that is being opened
     * @param engineFailure why the chosen engine does not draw
     * @param sceneFailure why the scene or its sky is not shown
     */
    public record Status(Optional<String> opening, Optional<String> engineFailure, Optional<String> sceneFailure) {
        public static final Status QUIET = new Status(Optional.empty(), Optional.empty(), Optional.empty());
    }
}
