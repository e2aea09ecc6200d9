package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.common.TornadoFunctions.Task9;
import uk.ac.manchester.tornado.api.types.arrays.FloatArray;
import uk.ac.manchester.tornado.api.types.arrays.IntArray;

/** The signature of {@link TornadoKernel#draw} for TornadoVM's task graphs. */
public interface DrawTask
        extends Task9<IntArray, FloatArray, float[], float[], float[], float[], float[], float[], Integer> {}
