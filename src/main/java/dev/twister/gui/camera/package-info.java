/** Moving the camera by keys and the mouse, and the bar of its keyframes. */
package dev.twister.gui.camera;
