package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.common.TornadoFunctions.Task10;

/** The signature of {@link TornadoKernel#draw} for TornadoVM's task graphs. */
public interface DrawTask
        extends Task10<int[], float[], float[], float[], float[], float[], float[], Integer, Integer, Integer> {}
