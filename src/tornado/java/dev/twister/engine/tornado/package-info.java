/**
 * The TornadoVM engine: the kernel in two parallel loops, and the plan that runs it. Built if an SDK is found. Depends
 * on the kernel, the engine package, the world's frame input, the image package, two limits of the scene, and
 * TornadoVM's API.
 */
package dev.twister.engine.tornado;
