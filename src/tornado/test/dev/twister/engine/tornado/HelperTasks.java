package dev.twister.engine.tornado;

/** Finds the kernels around helpers by name. */
public interface HelperTasks {
    HelperTask named(String helper);
}
