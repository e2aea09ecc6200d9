package dev.twister.gui;

import dev.twister.engine.EngineOffer;
import dev.twister.engine.Engines;
import dev.twister.gui.drawing.DrawnPicture;
import dev.twister.scene.Integrator;
import dev.twister.scene.Scene;
import dev.twister.world.animation.CameraMotion;
import dev.twister.world.animation.Turn;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Measures how soon the window shows a path-traced picture after a click on the integrator, and how often while the
 * camera moves. A program, run by hand: its arguments are such as {@code vector:benchmark}.
 */
final class PathFigures {
    private static final long MOVING_NANOS = TimeUnit.SECONDS.toNanos(6);
    private static final double SWAY_SECONDS = 0.02;

    private PathFigures() {}

    private record Shown(long nanos, int width, int samples, String engine) {}

    @SuppressWarnings("SystemOut") // a program for a person
    public static void main(String[] arguments) {
        int width = Integer.getInteger("twister.width", 1280);
        int height = Integer.getInteger("twister.height", 720);
        for (String argument : arguments) {
            String[] parts = argument.split(":", 2);
            EngineOffer offer = Engines.offers().stream()
                    .filter(one -> one.id().equals(parts[0]))
                    .findFirst()
                    .orElseThrow();
            Scene scene = WindowScenes.shipped(parts[1]);
            try (WindowDriver driver = WindowDriver.open(scene, offer)) {
                driver.run(() -> driver.stage.setWidth(width));
                driver.run(() -> driver.stage.setHeight(height));
                driver.awaitPicture(picture -> picture.engine().equals(offer.id()) && picture.isWhole());
                LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(Integer.getInteger("twister.wait", 3)));
                for (int round = 0; round < 2; round++) {
                    System.out.println(argument + " click " + round + ": " + click(driver, round));
                    System.out.println(argument + " moving: " + moving(driver));
                    driver.run(() -> driver.studio.edit(
                            "back", now -> now.withRendering(now.rendering().withIntegrator(Integrator.WHITTED))));
                    LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(1));
                }
            }
        }
        System.exit(0);
    }

    private static String click(WindowDriver driver, int round) {
        List<Shown> shown = new ArrayList<>();
        long[] start = {0};
        long first = WindowDriver.call(driver.studio::lastRequest);
        driver.run(() -> driver.studio
                .pictureProperty()
                .subscribe(picture ->
                        picture.filter(now -> now.request().number() > first).ifPresent(now -> shown.add(of(now)))));
        driver.run(() -> {
            start[0] = System.nanoTime();
            driver.studio.edit(
                    "integrator " + round,
                    now -> now.withRendering(now.rendering().withIntegrator(Integrator.PATH)));
        });
        LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(4));
        StringBuilder text = new StringBuilder();
        for (Shown one :
                WindowDriver.call(() -> List.copyOf(shown)).stream().limit(8).toList()) {
            text.append(String.format(
                    Locale.ROOT,
                    "%n    %.0f ms: %d wide, %d samples, %s",
                    (one.nanos() - start[0]) / 1e6,
                    one.width(),
                    one.samples(),
                    one.engine()));
        }
        return text.toString();
    }

    private static Shown of(DrawnPicture picture) {
        return new Shown(System.nanoTime(), picture.frame().width(), picture.samples(), picture.engine());
    }

    private static String moving(WindowDriver driver) {
        List<Shown> shown = new ArrayList<>();
        driver.run(() ->
                driver.studio.pictureProperty().subscribe(picture -> picture.ifPresent(now -> shown.add(of(now)))));
        driver.run(() -> driver.window.onPulse((_, _) -> driver.studio.moveCamera(camera ->
                CameraMotion.turn(camera, new Turn(camera.yawDegrees() > 0 ? -1 : 1, 0, false), SWAY_SECONDS))));
        LockSupport.parkNanos(MOVING_NANOS);
        driver.run(() -> driver.window.onPulse((_, _) -> {}));
        List<Shown> all = WindowDriver.call(() -> List.copyOf(shown));
        long longest = 0;
        for (int i = 1; i < all.size(); i++) {
            longest = Math.max(longest, all.get(i).nanos() - all.get(i - 1).nanos());
        }
        return String.format(
                Locale.ROOT,
                "%.1f FPS, longest gap %.0f ms, widths %s",
                (all.size() - 1) * 1e9 / (all.getLast().nanos() - all.get(0).nanos()),
                longest / 1e6,
                all.stream().map(Shown::width).distinct().toList());
    }
}
