/**
 * What draws: the {@link dev.twister.engine.Engine} interface, how engines are found, how their first frames settle,
 * and the engines of the JVM itself. Leans on the kernel, the world's frame input, and the image package.
 */
package dev.twister.engine;
