/**
 * The commands, one class each, and what they share. Leans on whatever they need, of the window on what opens it alone;
 * nothing leans on it.
 */
package dev.twister.cli;
