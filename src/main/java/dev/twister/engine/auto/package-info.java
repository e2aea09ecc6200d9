/**
 * Chooses the fastest engine: measured once per machine and version, remembered, and switched to while a slower one
 * renders. Depends on the engines, the world's frame input, the image package and {@code files}.
 */
package dev.twister.engine.auto;
