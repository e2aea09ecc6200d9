/** What a scene file says, as immutable records, and generated scenes. */
package dev.twister.scene;
