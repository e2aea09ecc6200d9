/** Parts of a material: emission, opacity, attenuation and the maps. */
package dev.twister.scene.material;
