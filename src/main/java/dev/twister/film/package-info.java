/** Films in one file: by ffmpeg, or as an animated PNG. Leans on {@code files} alone. */
package dev.twister.film;
