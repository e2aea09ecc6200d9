package dev.twister.gui.files;

import static org.assertj.core.api.Assertions.assertThat;

import dev.twister.gui.WindowDriver;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import javafx.scene.control.Button;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Files that take long to read. */
@Timeout(300)
class ReadingTest {
    private final List<String> said = new CopyOnWriteArrayList<>();
    private final CompletableFuture<String> interrupted = new CompletableFuture<>();

    /** Reads until it is interrupted. */
    private String readForEver() throws InterruptedException {
        try {
            new CountDownLatch(1).await();
            return "";
        } catch (InterruptedException end) {
            interrupted.complete("");
            throw end;
        }
    }

    private void begin(Reading reading) {
        reading.begin(
                "long.json",
                this::readForEver,
                _ -> said.add("done"),
                _ -> said.add("failed"),
                () -> said.add("canceled"));
    }

    @Test
    void anotherFileTakesThePlaceOfTheOneThatIsBeingRead() {
        try (WindowDriver driver = WindowDriver.open()) {
            Reading reading = new Reading();
            driver.run(() -> {
                begin(reading);
                reading.begin("b.json", () -> "b", said::add, _ -> {}, () -> {});
            });
            driver.await(() -> reading.presentProperty().get().isEmpty());
            interrupted.join();
            driver.pulse();
            assertThat(said).containsExactly("canceled", "b");
        }
    }

    @Test
    void aLongReadIsSaidAndCanBeCanceled() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> begin(driver.window.reading()));
            Button cancel = driver.find("#cancel-reading", Button.class);
            driver.await(() -> cancel.getParent().isVisible());
            assertThat(driver.text("reading")).isEqualTo("Reading long.json…");
            driver.run(cancel::fire);
            driver.await(() -> !cancel.getParent().isVisible());
            interrupted.join();
            assertThat(said).containsExactly("canceled");
            assertThat(driver.notice()).isEqualTo("Canceled reading long.json");
        }
    }

    @Test
    void escapeCancelsToo() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> begin(driver.window.reading()));
            driver.type(KeyCode.ESCAPE);
            interrupted.join();
            assertThat(said).containsExactly("canceled");
        }
    }

    @Test
    void theWindowClosesWhileAFileIsRead() {
        try (WindowDriver driver = WindowDriver.open()) {
            driver.run(() -> begin(driver.window.reading()));
        }
        interrupted.join();
    }
}
