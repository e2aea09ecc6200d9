package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.common.TornadoFunctions.Task20;

/** The signature of {@link TornadoKernel#draw} for TornadoVM's task graphs. */
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
