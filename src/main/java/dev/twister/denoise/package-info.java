/**
 * Removal of noise from pictures of linear radiance. A {@code DenoiserProvider} offers a denoiser, found by
 * {@code ServiceLoader}; the one of this package loads the library Open Image Denoise, which is optional, through the
 * foreign function and memory API. It depends on no other package of Twister.
 */
package dev.twister.denoise;
