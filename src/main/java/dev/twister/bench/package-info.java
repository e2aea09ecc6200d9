/** The benchmark: warm-up, measured frames, statistics, comparison of pictures, and reports. */
package dev.twister.bench;
