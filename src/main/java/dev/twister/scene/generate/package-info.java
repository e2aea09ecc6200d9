/** Bodies that a program places: generated scenes and poured spheres. */
package dev.twister.scene.generate;
