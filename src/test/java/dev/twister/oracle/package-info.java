/**
 * The oracle: the design's equations again, recursive, in double precision, without shortcuts, and comparisons of
 * engines with it. Its input is scenes and skyboxes instead of the kernel's arrays, so that layout errors show.
 */
package dev.twister.oracle;
