/**
 * A scene rendered to files: pictures band by band, numbered frames and films, what moves in them, and how long it
 * still takes. What the commands and the window's dialog share. Leans on the scene, its world, physics and motion
 * files, engines and the files of pictures and films.
 */
package dev.twister.render;
