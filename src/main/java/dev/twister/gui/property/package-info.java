/**
 * The properties that the panel shows, without JavaFX: tables of numbers with their labels, keys, units and sliders,
 * the colors of lights and screens, and presets.
 */
package dev.twister.gui.property;
