/**
 * What all threads read while a frame is drawn: the input, prepared for lanes, and which shortcuts are taken. The
 * compiler inlines of it what it likes; no vector is taken or returned.
 */
package dev.twister.engine.vector.frame;
