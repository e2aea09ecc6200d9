/**
 * The desktop application. {@link dev.twister.gui.studio.Studio} holds what a person sees and edits: the scene, an
 * immutable record that each edit replaces, the engine chosen, and how it is drawn. Views show the studio's properties
 * and call its methods; they decide nothing. {@link dev.twister.gui.drawing} draws on a thread of its own; nothing here
 * waits for it. What can be said without JavaFX is in {@code gui.drawing} and {@code gui.model}. Leans on everything
 * but the commands.
 */
package dev.twister.gui;
