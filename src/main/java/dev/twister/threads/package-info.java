/** Threads that work together in lockstep. Leans on no other package of Twister; engines and physics lean on it. */
package dev.twister.threads;
