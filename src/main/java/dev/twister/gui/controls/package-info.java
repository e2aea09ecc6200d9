/** The commands with their keys, the dialogs, and the controls that several rooms of the window use. */
package dev.twister.gui.controls;
