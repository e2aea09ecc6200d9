/** The panel at the side: its sections, and the rows that they are made of. */
package dev.twister.gui.panel;
