/**
 * Files written whole or not at all, and why not. Leans on no other package of Twister; whoever writes a file a person may
 * want to keep leans on it.
 */
package dev.twister.files;
