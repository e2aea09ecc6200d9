/**
 * The TornadoVM engine: the kernel under two parallel loops, and the plan that schedules it. Built where an SDK is
 * found. Leans on the kernel, the engine package, the world's frame input, the image package, two limits of the scene,
 * and TornadoVM's API.
 */
package dev.twister.engine.tornado;
