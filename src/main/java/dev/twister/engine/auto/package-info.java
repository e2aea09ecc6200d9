/**
 * Which engine is the fastest here: measured once for each machine and version, remembered, and gone over to while a
 * slower one draws. Leans on the engines, the world's frame input, the image package and {@code files}.
 */
package dev.twister.engine.auto;
