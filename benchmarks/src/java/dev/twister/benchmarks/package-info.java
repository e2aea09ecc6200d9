/** JMH microbenchmarks: each step of the kernel by itself, and whole frames by each engine. */
package dev.twister.benchmarks;
