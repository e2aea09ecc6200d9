package dev.twister.engine.vector;

/**
 * One step of drawing a tile. Stages are called through this interface, from one place, so that the compiler does not
 * inline them into their caller: each keeps an inlining budget of its own, without which vectors become objects.
 */
@FunctionalInterface
interface Stage {
    void run(Tile tile, Drawing drawing);

    /** Runs some stages in order. */
    static void runAll(Stage[] stages, Tile tile, Drawing drawing) {
        for (Stage stage : stages) {
            stage.run(tile, drawing);
        }
    }

    /**
     * Runs the stages of a list with so many packets; not for an empty one, as the compiler makes objects in a loop that
     * hardly any call of a stage comes to.
     */
    static void runFor(int packets, Stage[] stages, Tile tile, Drawing drawing) {
        if (packets > 0) {
            runAll(stages, tile, drawing);
        }
    }
}
