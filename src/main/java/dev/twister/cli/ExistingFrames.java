package dev.twister.cli;

/** What is done about frames of an earlier run. */
enum ExistingFrames {
    REFUSED,
    REPLACED,
    KEPT
}
