/** The picture in the window, what is drawn over it, and what measures it: inspector, histogram, frame times. */
package dev.twister.gui.picture;
