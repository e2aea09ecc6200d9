package dev.twister.bench;

/** An engine that could not be measured, and why. */
public record EngineFailure(String engine, String message) {}
