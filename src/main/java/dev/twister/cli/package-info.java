/** The commands, one class each, and what they share. */
package dev.twister.cli;
