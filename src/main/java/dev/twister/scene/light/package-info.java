/** Lists and groups of lights. */
package dev.twister.scene.light;
