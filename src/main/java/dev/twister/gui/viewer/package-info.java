/**
 * Pictures of files, looked at beside the window, compared with the rendering, and lit by other strengths of lights.
 */
package dev.twister.gui.viewer;
