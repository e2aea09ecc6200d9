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

/**
 * Draws on a thread of its own, always by the newest request. Threads that ask and show never wait: {@link #request}
 * and {@link #takeNewest} return at once.
 */
public final class DrawingLoop implements AutoCloseable {
    /** Where nothing is asked for in so long, the engine rests. */
    private static final long REST_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final PictureExchange exchange = new PictureExchange();
    private final PictureWork work;
    private final Thread thread;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private Optional<DrawingRequest> newest = Optional.empty();
    private boolean due;
    private boolean closed;
    private final Deque<RadianceQuestion> questions = new ArrayDeque<>();
    private volatile DrawingStatus status = DrawingStatus.QUIET;

    private record RadianceQuestion(DrawnPicture picture, CompletableFuture<Optional<float[]>> answer) {}

    /**
     * A loop that is not started yet.
     *
     * @param skies where panoramas come from
     * @param meshes where meshes come from
     * @param substitute the engine that draws until the chosen one is ready, and where that fails; must open at once
     */
    public DrawingLoop(SkyShelf skies, MeshShelf meshes, EngineOffer substitute) {
        this(skies, meshes, substitute, System::nanoTime);
    }

    /** The same by another clock than {@link System#nanoTime}. */
    DrawingLoop(SkyShelf skies, MeshShelf meshes, EngineOffer substitute, LongSupplier clock) {
        work = new PictureWork(exchange, skies, meshes, substitute, this::newest, this::wake, clock);
        thread = Thread.ofPlatform().daemon().name("drawing").unstarted(this::run);
    }

    /** Starts the thread, which waits for a request. */
    public void start() {
        thread.start();
    }

    /** From the next picture on, this is what is drawn. */
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
     * From now on each whole picture is handed to that as well, on the drawing thread, which goes on drawing when it
     * returns; the pixels are to be read until then.
     */
    public void watch(Consumer<DrawnPicture> watcher) {
        work.watch(Optional.of(watcher));
    }

    /** No one watches any more. */
    public void unwatch() {
        work.watch(Optional.empty());
    }

    /**
     * The linear samples that a refined picture has gathered, as {@link dev.twister.image.Frame#radiance} has them: as
     * many as were seen, or more by now. Empty where it was not refined, or another picture is drawn by now.
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

    public DrawingStatus status() {
        return status;
    }

    /** Lets the thread end after the picture it is at, and close its engine; does not wait for it. */
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

    /** Waits for the thread to end; whether it did. */
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

    /** The caller waits, so every request is answered. */
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

    /** Waits a while, and returns whether there is nothing to do even then. */
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

    /** The newest request, once there is something to do for it; empty when the loop is closed. */
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

    /** What is asked for by now; empty when the loop is closed. */
    private Optional<DrawingRequest> newest() {
        lock.lock();
        try {
            return closed ? Optional.empty() : newest;
        } finally {
            lock.unlock();
        }
    }

    /** There may be something to do for a request that was answered. */
    private void wake() {
        lock.lock();
        try {
            due = newest.isPresent();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }
}
