package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.common.TornadoFunctions.Task20;

/** A kernel with {@link TornadoKernel#draw}'s arguments, as TornadoVM's task graphs take it. */
public interface DrawTask
        extends Task20<
                int[],
                float[],
                int[],
                float[],
                float[],
                float[],
                float[],
                float[],
                float[],
                float[],
                int[],
                float[],
                float[],
                Integer,
                Integer,
                Integer,
                Integer,
                Integer,
                Integer,
                Integer> {}
