/** A decoder of WebP pictures: the container, VP8 key frames, VP8L and alpha. Leans on no other package of Twister. */
package dev.twister.sky.webp;
