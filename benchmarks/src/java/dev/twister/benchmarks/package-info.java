/**
 * JMH microbenchmarks: each step of the kernel by itself, and whole frames by each engine; and how a cold JVM starts.
 */
package dev.twister.benchmarks;
