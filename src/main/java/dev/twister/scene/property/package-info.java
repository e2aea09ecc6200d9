/** The numbers of a scene: their ranges and limits, and which of them tracks animate. */
package dev.twister.scene.property;
