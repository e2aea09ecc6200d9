/**
 * Finished pictures: the frame an engine fills, and the PNG and Radiance HDR files made of it. Leans on no other
 * package of Twister.
 */
package dev.twister.image;
