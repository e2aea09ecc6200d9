/**
 * The desktop application. {@link dev.twister.gui.studio.Studio} holds the application's state: the scene, an immutable
 * record that each edit replaces, the chosen engine, and the display options. Views show the studio's properties and
 * call its methods; they hold no state of the scene. {@link dev.twister.gui.drawing} renders on its own thread; nothing
 * here waits for it. Code that needs no JavaFX is in {@code gui.edit}, {@code gui.picking}, {@code gui.property} and
 * {@code gui.drawing}. Uses all packages but the commands.
 */
package dev.twister.gui;
