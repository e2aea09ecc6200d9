/** How a pixel comes about: the path of its rays, step by step, with the kernel's own numbers. */
package dev.twister.explain;
