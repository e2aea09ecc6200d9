/** Movement of the camera by keys and keyframes, and the curves of tracks. */
package dev.twister.world.animation;
