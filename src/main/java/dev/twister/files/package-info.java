/**
 * Files written whole or not at all, and why not; where a user's files are, and which version wrote them. Depends on no
 * other package of Twister.
 */
package dev.twister.files;
