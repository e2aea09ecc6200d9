/**
 * The oracle: the design's equations again, recursive, in double precision, without one trick, and what holds engines
 * to it. It takes scenes and skyboxes, not the kernel's arrays, so that a mistake in the layout cannot hide.
 */
package dev.twister.oracle;
