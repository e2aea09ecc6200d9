/**
 * Panoramas: Radiance {@code .hdr}, ordinary images and the procedural daylight sky, all as linear radiance. Leans on
 * no other package of Twister.
 */
package dev.twister.sky;
