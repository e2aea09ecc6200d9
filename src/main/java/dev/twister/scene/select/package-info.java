/** Bodies and titles of a scene by what a user says of them: numbers, tags, visibility. */
package dev.twister.scene.select;
