/** A reader of OpenEXR files, whichever program wrote them. */
package dev.twister.exr;
