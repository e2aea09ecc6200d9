/**
 * The state of a frame that all threads read: the input, prepared for lanes, and the enabled shortcuts. C2 decides what
 * it inlines here, because no method takes or returns a vector.
 */
package dev.twister.engine.vector.frame;
