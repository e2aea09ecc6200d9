/** Films in one file: encoded by ffmpeg, or as an animated PNG. Depends on {@code files} and {@code threads}. */
package dev.twister.film;
