/**
 * The edited scene, its picture, and all that may change them. Views bind to the properties of
 * {@link dev.twister.gui.studio.Studio} and call its methods.
 */
package dev.twister.gui.studio;
