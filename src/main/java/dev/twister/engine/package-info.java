/**
 * The {@link dev.twister.engine.Engine} interface, engine discovery, the settling of first frames, and the JVM's own
 * engines. Depends on the kernel, the world's frame input and the image package.
 */
package dev.twister.engine;
