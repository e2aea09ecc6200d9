/** The start page: shipped and recent scenes as pictures. */
package dev.twister.gui.gallery;
